# SPDX-License-Identifier: LGPL-2.1-or-later
# What is installed is complete, can be moved, and other projects can build on it.
cmake --install "$(dirname "$CAUDAL")" --prefix "$PWD/first" >installed.log || cat installed.log
mv first prefix
version=$("$CAUDAL" --version)
unset CAUDAL

same() {
  [ "$2" = "$3" ] && echo "$1: as built" || echo "$1: $2, not $3"
}
same "program" "$(prefix/bin/caudal --version)" "$version"
same "headers" "$(cd prefix/include/caudal && find . -name '*.h' | sort)" \
  "$(cd "$CAUDAL_SOURCE_DIR/include/caudal" && find . -name '*.h' | sort)"
same "cases" "$(cd prefix/share/caudal/prm && find . -type f | sort)" \
  "$(cd "$CAUDAL_SOURCE_DIR/prm" && find . -type f | sort)"
ldd prefix/bin/caudal | grep -c "libcaudal.*=> $PWD/prefix/"
ls prefix/share/caudal/scripts

scripts=$PWD/prefix/share/caudal/scripts
same "scripts/swim" "$(CAUDAL_RANKS=1 "$scripts/swim" --version)" "$version"
CAUDAL_RANKS=1 "$scripts/swim" --check --fast "$PWD/prefix/share/caudal/prm/benchmarks/ring.prm" >/dev/null &&
  echo "scripts/swim checks an installed case"
"$scripts/benchmark" --list >/dev/null && echo "scripts/benchmark lists its cases"
"$scripts/sweep" --help >/dev/null && echo "scripts/sweep tells its options"
PYTHONPATH=$PWD/prefix/share/caudal/python /usr/bin/python3 -c 'import caudal
print(caudal.__file__)' | sed "s|$PWD/|import caudal finds |"

mkdir project
cat >project/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.18)
project(user LANGUAGES CXX)
find_package(caudal 0.2 REQUIRED)
add_executable(user user.cc)
target_link_libraries(user caudal::caudal)
caudal_add_plugin(plugin plugin.cc)
get_target_property(_program caudal::program LOCATION)
message(STATUS "The program is ${_program}")
END
cat >project/user.cc <<'END'
#include <caudal/base/version.h>
#include <iostream>
int main()
{
  std::cout << caudal::get_version() << std::endl;
}
END
echo '#include <caudal/base/version.h>' >project/plugin.cc
cmake -S project -B project/build -D CMAKE_PREFIX_PATH="$PWD/prefix" >project.log 2>&1 &&
  cmake --build project/build >>project.log 2>&1 || cat project.log
sed -n "s|^-- The program is $PWD/|find_package finds |p" project.log
same "a program that is linked to the library" "$(project/build/user)" "$version"
[ -e project/build/libplugin.so ] && echo "a plug-in is built"
