/* Functions of named scalars at many points; p[k] is a column, or one number if its stride is 0,
 * and y[k] a column, or NULL if it is not wanted. */
#include <math.h>
#include <stdint.h>

#define SHOWN __attribute__((visibility("default")))
enum { POINTS = 512, MOST = 40 };   /* points in a block; arguments or results of a function */

typedef void block_function(int64_t n, const double **p, double **y);

/* fmax and fmin of C, which a loop can be vectorised with: a NaN gives way to a number. */
static inline double larger(double a, double b) { return a > b || b != b ? a : b; }
static inline double smaller(double a, double b) { return a < b || b != b ? a : b; }

/* One block of points, every argument a column of it. */
static void sweep_block(block_function *f, int n_in, int n_out, int64_t from, int64_t end,
    double (*same)[POINTS], const double *const *p, const int64_t *stride, double *const *y)
{
    const double *columns[MOST];
    double *results[MOST], unwanted[POINTS] __attribute__((aligned(64)));
    for (int k = 0; k < n_in; ++k)
        columns[k] = stride[k] ? p[k] + from : same[k];
    for (int k = 0; k < n_out; ++k)
        results[k] = y[k] ? y[k] + from : unwanted;
    f(end - from < POINTS ? end - from : POINTS, columns, results);
}

static void sweep(block_function *f, int n_in, int n_out, int64_t n, int64_t threads,
    const double *const *p, const int64_t *stride, double *const *y)
{
    double same[MOST][POINTS] __attribute__((aligned(64)));
    for (int k = 0; k < n_in; ++k)
        for (int i = 0; i < POINTS && !stride[k]; ++i)
            same[k][i] = *p[k];
    /* a short block first, so that the others begin where a line of the cache does */
    const int64_t odd = (8 - (int64_t)((uintptr_t)y[0] / sizeof(double) % 8)) % 8;
    const int64_t head = odd < n ? odd : n;
    sweep_block(f, n_in, n_out, 0, head, same, p, stride, y);
    if (threads <= 1) {
        for (int64_t from = head; from < n; from += POINTS)
            sweep_block(f, n_in, n_out, from, n, same, p, stride, y);
        return;
    }
#pragma omp parallel for schedule(static) num_threads((int)threads)
    for (int64_t from = head; from < n; from += POINTS)
        sweep_block(f, n_in, n_out, from, n, same, p, stride, y);
}
