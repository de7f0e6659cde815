/* Functions of states, inputs and parameters at many points, some of them side by side. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = @LANES@ };
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define SHOWN __attribute__((visibility("default")))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
#define W(k) w[k][l]
#define V(k) const double v##k =
typedef double lanes[LANES];

/* @ELEMENTARY@ */

/* What is wanted of each point: `size` elements of the results, numbered through all of them. */
typedef struct {
    double *data;                          /* [n][size] */
    int64_t size;
    const int32_t *element;                /* [size] */
} wanted_t;

typedef struct {
    int64_t n, threads, n_wanted;
    const double *const *given;            /* [N_IN] columns [n], or one number with stride 0 */
    const int64_t *stride;
    const wanted_t *wanted;
} points_t;

/* @SIZES@ */
/* @MODEL@ */

/* Which parts of the results are asked for, one bit each. */
static int parts(const points_t *job)
{
    int found = 0;
    for (int64_t j = 0; j < job->n_wanted; ++j)
        for (int64_t k = 0; k < job->wanted[j].size; ++k)
            for (int r = 0; r < N_RESULTS; ++r)
                if (job->wanted[j].element[k] >= FIRST[r] && job->wanted[j].element[k] < FIRST[r + 1])
                    found |= PART[r];
    return found;
}

/* Points `from` to `end`, no more than there are lanes: unused lanes repeat the last. */
static void some(const points_t *job, int asked, lanes *w, int64_t from, int64_t end)
{
    const int count = (int)(end - from);
    for (int k = 0; k < N_IN; ++k) {
        const int64_t stride = job->stride[k];
        const double *column = job->given[k] + stride * from;
        for (int l = 0; l < LANES && stride; ++l)
            w[k][l] = column[l < count ? l : count - 1];
    }
    evaluate(w, asked);
    for (int64_t j = 0; j < job->n_wanted; ++j) {
        const wanted_t *wanted = job->wanted + j;
        double *out = wanted->data + from * wanted->size;
        for (int64_t k = 0; k < wanted->size; ++k)
            for (int l = 0; l < count; ++l)
                out[l * wanted->size + k] = w[PLACE[wanted->element[k]]][l];
    }
}

SHOWN void points(const points_t *job)
{
    const int64_t blocks = (job->n + LANES - 1) / LANES;
    const int asked = parts(job);
#pragma omp parallel num_threads((int)job->threads) if (job->threads > 1)
    {
        lanes w[N_ROWS] __attribute__((aligned(64)));
        constants(w);
        for (int k = 0; k < N_IN; ++k)
            for (int l = 0; l < LANES; ++l)
                w[k][l] = *job->given[k];
#pragma omp for schedule(static)
        for (int64_t b = 0; b < blocks; ++b) {
            const int64_t from = b * LANES, end = from + LANES;
            some(job, asked, w, from, end < job->n ? end : job->n);
        }
    }
}
