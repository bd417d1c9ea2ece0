// SPDX-License-Identifier: LGPL-2.1-or-later
// Counts a program's calls of MPI: each rank writes a file <$CAUDAL_MPI_COUNTS>.<rank> as it ends,
// a line for each kind of collective call among two ranks or more, "<kind> <calls>", and the
// processor seconds within MPI, waiting included, and those of all: "seconds_in_mpi", "seconds". The
// program is not changed:
// Where ranks share cores (Open MPI gives way then by sched_yield), a rank that waits sleeps for a moment
// instead: the scheduler would let it wait for others' time slices at each message.
//   mpicc -shared -fPIC mpi_counts.c -o counts.so
//   CAUDAL_MPI_COUNTS=folder/counts LD_PRELOAD=counts.so program
// By MPI's profiling interface (MPI standard, chapter "Tool support").
#define _GNU_SOURCE
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define LARGEST_NUMBER_OF_KINDS 64

static struct
{
  const char *name;
  long        calls;
} kinds[LARGEST_NUMBER_OF_KINDS];
static double seconds_in_mpi = 0;

static double get_time(void)
{
  struct timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

static void count(const char *name, MPI_Comm communicator)
{
  int n_ranks = 1;
  PMPI_Comm_size(communicator, &n_ranks);
  for (int i = 0; n_ranks > 1 && i < LARGEST_NUMBER_OF_KINDS; ++i)
    if (kinds[i].name == NULL || strcmp(kinds[i].name, name) == 0)
    {
      kinds[i].name = name;
      ++kinds[i].calls;
      return;
    }
}

static void write_counts(void)
{
  int  rank = 0;
  char name[4096];
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const char *stem = getenv("CAUDAL_MPI_COUNTS");
  snprintf(name, sizeof(name), "%s.%d", stem ? stem : "mpi_counts", rank);
  FILE *file = fopen(name, "w");
  if (file == NULL)
    return;
  for (int i = 0; i < LARGEST_NUMBER_OF_KINDS && kinds[i].name != NULL; ++i)
    fprintf(file, "%s %ld\n", kinds[i].name, kinds[i].calls);
  fprintf(file, "seconds_in_mpi %.6f\nseconds %.6f\n", seconds_in_mpi, get_time());
  fclose(file);
}

int sched_yield(void)
{
  const struct timespec pause = {0, 20000};
  nanosleep(&pause, NULL);
  return 0;
}

int MPI_Finalize(void)
{
  write_counts();
  return PMPI_Finalize();
}

#define TIMED(NAME, DECLARATION, ARGUMENTS)                                                        \
  int MPI_##NAME DECLARATION                                                                       \
  {                                                                                                \
    const double begin  = get_time();                                                              \
    const int    result = PMPI_##NAME ARGUMENTS;                                                   \
    seconds_in_mpi += get_time() - begin;                                                          \
    return result;                                                                                 \
  }

#define COLLECTIVE(NAME, DECLARATION, ARGUMENTS)                                                   \
  int MPI_##NAME DECLARATION                                                                       \
  {                                                                                                \
    const double begin = get_time();                                                               \
    count(#NAME, comm);                                                                            \
    const int result = PMPI_##NAME ARGUMENTS;                                                      \
    seconds_in_mpi += get_time() - begin;                                                          \
    return result;                                                                                 \
  }

// Shorter names of parameter lists.
#define TYPE MPI_Datatype
#define COMM MPI_Comm comm
#define REQUEST MPI_Request *request
#define REQUESTS int n, MPI_Request *requests
#define STATUS MPI_Status *status
#define SENT const void *s, int sn, TYPE st
#define RECEIVED void *r, int rn, TYPE rt
#define SENT_V const void *s, const int *sn, const int *sd, TYPE st
#define RECEIVED_V void *r, const int *rn, const int *rd, TYPE rt

COLLECTIVE(Barrier, (COMM), (comm))
COLLECTIVE(Ibarrier, (COMM, REQUEST), (comm, request))
COLLECTIVE(Bcast, (void *b, int n, TYPE t, int root, COMM), (b, n, t, root, comm))
COLLECTIVE(Ibcast, (void *b, int n, TYPE t, int root, COMM, REQUEST), (b, n, t, root, comm, request))
COLLECTIVE(Reduce, (const void *s, void *r, int n, TYPE t, MPI_Op op, int root, COMM),
           (s, r, n, t, op, root, comm))
COLLECTIVE(Allreduce, (const void *s, void *r, int n, TYPE t, MPI_Op op, COMM),
           (s, r, n, t, op, comm))
COLLECTIVE(Iallreduce, (const void *s, void *r, int n, TYPE t, MPI_Op op, COMM, REQUEST),
           (s, r, n, t, op, comm, request))
COLLECTIVE(Scan, (const void *s, void *r, int n, TYPE t, MPI_Op op, COMM), (s, r, n, t, op, comm))
COLLECTIVE(Exscan, (const void *s, void *r, int n, TYPE t, MPI_Op op, COMM), (s, r, n, t, op, comm))
COLLECTIVE(Reduce_scatter, (const void *s, void *r, const int *n, TYPE t, MPI_Op op, COMM),
           (s, r, n, t, op, comm))
COLLECTIVE(Reduce_scatter_block, (const void *s, void *r, int n, TYPE t, MPI_Op op, COMM),
           (s, r, n, t, op, comm))
COLLECTIVE(Gather, (SENT, RECEIVED, int root, COMM), (s, sn, st, r, rn, rt, root, comm))
COLLECTIVE(Gatherv, (SENT, RECEIVED_V, int root, COMM), (s, sn, st, r, rn, rd, rt, root, comm))
COLLECTIVE(Scatter, (SENT, RECEIVED, int root, COMM), (s, sn, st, r, rn, rt, root, comm))
COLLECTIVE(Scatterv, (SENT_V, RECEIVED, int root, COMM), (s, sn, sd, st, r, rn, rt, root, comm))
COLLECTIVE(Allgather, (SENT, RECEIVED, COMM), (s, sn, st, r, rn, rt, comm))
COLLECTIVE(Allgatherv, (SENT, RECEIVED_V, COMM), (s, sn, st, r, rn, rd, rt, comm))
COLLECTIVE(Alltoall, (SENT, RECEIVED, COMM), (s, sn, st, r, rn, rt, comm))
COLLECTIVE(Alltoallv, (SENT_V, RECEIVED_V, COMM), (s, sn, sd, st, r, rn, rd, rt, comm))
COLLECTIVE(Comm_dup, (COMM, MPI_Comm *other), (comm, other))
COLLECTIVE(Comm_split, (COMM, int colour, int key, MPI_Comm *other), (comm, colour, key, other))
COLLECTIVE(Comm_create, (COMM, MPI_Group group, MPI_Comm *other), (comm, group, other))

TIMED(Send, (SENT, int to, int tag, COMM), (s, sn, st, to, tag, comm))
TIMED(Ssend, (SENT, int to, int tag, COMM), (s, sn, st, to, tag, comm))
TIMED(Rsend, (SENT, int to, int tag, COMM), (s, sn, st, to, tag, comm))
TIMED(Isend, (SENT, int to, int tag, COMM, REQUEST), (s, sn, st, to, tag, comm, request))
TIMED(Issend, (SENT, int to, int tag, COMM, REQUEST), (s, sn, st, to, tag, comm, request))
TIMED(Irsend, (SENT, int to, int tag, COMM, REQUEST), (s, sn, st, to, tag, comm, request))
TIMED(Recv, (RECEIVED, int from, int tag, COMM, STATUS), (r, rn, rt, from, tag, comm, status))
TIMED(Irecv, (RECEIVED, int from, int tag, COMM, REQUEST), (r, rn, rt, from, tag, comm, request))
TIMED(Probe, (int from, int tag, COMM, STATUS), (from, tag, comm, status))
TIMED(Iprobe, (int from, int tag, COMM, int *flag, STATUS), (from, tag, comm, flag, status))
TIMED(Wait, (REQUEST, STATUS), (request, status))
TIMED(Waitall, (REQUESTS, STATUS), (n, requests, status))
TIMED(Waitany, (REQUESTS, int *index, STATUS), (n, requests, index, status))
TIMED(Waitsome, (REQUESTS, int *done, int *indices, STATUS), (n, requests, done, indices, status))
TIMED(Test, (REQUEST, int *flag, STATUS), (request, flag, status))
TIMED(Testall, (REQUESTS, int *flag, STATUS), (n, requests, flag, status))
