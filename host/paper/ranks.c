/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/message.h"
#include "paper/ranks.h"

#if GLINT_WITH_MPI
#include <mpi.h>
#endif

/* The environment that launchers give: Open MPI's mpirun; MPICH's and Slurm's by PMI. */
static bool number_of(const char *const names[], int *value)
{
    for (size_t i = 0; names[i]; i++) {
        const char *text = getenv(names[i]);
        if (!text || !*text)
            continue;
        char *end;
        const long number = strtol(text, &end, 10);
        if (*end || number < 0 || number > INT_MAX)
            return false;
        *value = (int)number;
        return true;
    }
    return false;
}

bool ranks_launched(struct ranks *ranks)
{
    static const char *const counts[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", NULL};
    static const char *const indices[] = {"OMPI_COMM_WORLD_RANK", "PMI_RANK", NULL};
    int index, count;
    const bool launched = number_of(counts, &count) && number_of(indices, &index) && index < count;
    *ranks = launched ? (struct ranks){index, count} : (struct ranks){0, 1};
    return launched;
}

static bool joined;

/* mpirun ends all ranks when the first has ended with an error: not before rank 0 has said why. */
static void wait_for_first(void)
{
    if (!joined)
        sleep(2);
}

void ranks_let_first_speak(void)
{
    struct ranks ranks;
    if (ranks_launched(&ranks) && ranks.index > 0 && freopen("/dev/null", "w", stderr))
        atexit(wait_for_first);
}

#if GLINT_WITH_MPI
struct ranks ranks_begin(void)
{
    struct ranks ranks;
    if (!ranks_launched(&ranks))
        return ranks;
    int provided;
    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS || provided < MPI_THREAD_FUNNELED)
        fail("search: MPI does not start with threads");
    joined = true;
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.index);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.count);
    return ranks;
}

void ranks_gather(const struct ranks *ranks, const void *mine, size_t bytes, void *all)
{
    if (ranks->count == 1)
        memcpy(all, mine, bytes);
    else
        MPI_Allgather(mine, (int)bytes, MPI_BYTE, all, (int)bytes, MPI_BYTE, MPI_COMM_WORLD);
}

void ranks_share(const struct ranks *ranks, void *value, size_t bytes)
{
    if (ranks->count > 1)
        MPI_Bcast(value, (int)bytes, MPI_BYTE, 0, MPI_COMM_WORLD);
}

void ranks_end(const struct ranks *ranks)
{
    struct ranks launched;
    (void)ranks;
    if (ranks_launched(&launched))
        MPI_Finalize();
}

char *ranks_library(void)
{
    char text[MPI_MAX_LIBRARY_VERSION_STRING], *line;
    int length;
    MPI_Get_library_version(text, &length);
    text[strcspn(text, ",\n")] = '\0';
    line = strdup(text);
    return line;
}
#else
struct ranks ranks_begin(void)
{
    struct ranks ranks;
    ranks_launched(&ranks);
    if (ranks.count > 1)
        fail("search: this build is without MPI; install libopenmpi-dev and openmpi-bin, and build again");
    return ranks;
}

void ranks_gather(const struct ranks *ranks, const void *mine, size_t bytes, void *all)
{
    (void)ranks;
    memcpy(all, mine, bytes);
}

void ranks_share(const struct ranks *ranks, void *value, size_t bytes)
{
    (void)ranks;
    (void)value;
    (void)bytes;
}

void ranks_end(const struct ranks *ranks)
{
    (void)ranks;
}

char *ranks_library(void)
{
    return NULL;
}
#endif
