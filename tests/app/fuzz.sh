# SPDX-License-Identifier: LGPL-2.1-or-later
# A short campaign of mutated parameter files, meshes and tables, and of damaged checkpoints: no crash,
# no hang, a sentence for each error.
"$CAUDAL_SOURCE_DIR/scripts/benchmarks/fuzz" --mutations 60 --inputs 15 --checkpoints 15 --folder . 2>counts
