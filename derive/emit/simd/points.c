/* Functions of states, inputs and parameters at many points, some points side by side.
 *
 * An argument is a column, or one number if its stride is 0; a result is rows of so many numbers,
 * one row for each point, or NULL if it is not wanted. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = @LANES@ };
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define SHOWN __attribute__((visibility("default")))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* @ELEMENTARY@ */

typedef struct {
    int64_t n, threads;
    const double *const *in;     /* [arguments] */
    const int64_t *stride;
    double *const *out;          /* [results], each [n][size] or NULL */
} points_t;

/* What a function computes in rows w: arguments first, then whatever comes of them. `place` is for
 * every element of every result the row that it stands in; row 0 holds zeros. */
typedef struct {
    int n_in, n_out, rows;
    const int16_t *in;           /* [n_in] which of the arguments */
    const int16_t *size;         /* [n_out] */
    const int16_t *place;
    void (*run)(lanes *w);
} function_t;

/* Points from `from` to `end`, no more than there are lanes. */
static void some(const function_t *f, const points_t *job, lanes *w, int64_t from, int64_t end)
{
    const int count = (int)(end - from);
    for (int k = 0; k < f->n_in; ++k) {
        const int64_t stride = job->stride[f->in[k]];
        const double *column = job->in[f->in[k]] + stride * from;
        for (int l = 0; l < LANES && stride; ++l)
            w[1 + k][l] = column[l < count ? l : count - 1];
    }
    f->run(w);
    for (int r = 0, e = 0; r < f->n_out; e += f->size[r++]) {
        double *out = job->out[r];
        if (!out)
            continue;
        out += from * f->size[r];
        for (int k = 0; k < f->size[r]; ++k)
            for (int l = 0; l < count; ++l)
                out[l * f->size[r] + k] = w[f->place[e + k]][l];
    }
}

static void all(const function_t *f, const points_t *job)
{
    const int64_t blocks = (job->n + LANES - 1) / LANES;
#pragma omp parallel num_threads((int)job->threads) if (job->threads > 1)
    {
        lanes w[f->rows] __attribute__((aligned(64)));
        for (int l = 0; l < LANES; ++l)
            w[0][l] = 0.0;
        for (int k = 0; k < f->n_in; ++k)
            for (int l = 0; l < LANES; ++l)
                w[1 + k][l] = *job->in[f->in[k]];
#pragma omp for schedule(static)
        for (int64_t b = 0; b < blocks; ++b) {
            const int64_t from = b * LANES, left = job->n - from;
            some(f, job, w, from, left < LANES ? job->n : from + LANES);
        }
    }
}

/* @FUNCTIONS@ */
