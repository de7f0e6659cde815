/* What every kernel of a model begins with; the model and a driver follow. Compiled with
 *   DRIVER   1: many trajectories side by side; 2: a single one
 *   CARRY    which of the sets of states below
 *   VARYING  whether inputs change in time
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef DRIVER
#define DRIVER 1
#endif
#ifndef CARRY
#define CARRY 0
#endif
#ifndef VARYING
#define VARYING 0
#endif
/* @ALWAYS@ */

#if DRIVER == 2
enum { LANES = @NODES@ };                    /* moments of a step */
#else
enum { LANES = @LANES@ };                    /* trajectories */
#endif
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* @ELEMENTARY@ */

INLINE double larger(double a, double b) { return a > b ? a : b; }
INLINE double smaller(double a, double b) { return a < b ? a : b; }

/* ---- the job ------------------------------------------------------------------------------ */

/* @SIZES@ */
enum { ROWS = NS + NY };                     /* states, then outputs */
enum { TILE = 64, RETRIES = 4, TERMS = 16, WATCHES = 32 };
enum { RUNNING = -1, OK = 0, NON_FINITE = 1, STEP_LIMIT = 2, UNSURE = 3 };

static const double SCALE_FLOOR = 1e-6;    /* SI: a state's error is relative to at least this */
static const double FINEST = 2e-14;        /* local tolerance that rounding still allows */
static const double SHORTEST = 1e-12;      /* step / t_end at which a lane has got stuck */

/* An input over time: polynomials, each from its start until that of the next. */
typedef struct {
    int64_t pieces, terms;                 /* number of polynomials, and of coefficients of each */
    const double *start;                   /* [pieces], the first of them not after 0 */
    int64_t start_stride;                  /* to those of the next trajectory; 0 if shared */
    const double *value;                   /* [pieces][1 + terms]: m, then a polynomial in t - m */
    int64_t value_stride;
} signal_t;

/* A row whose extreme is wanted, and when it reaches a limit. */
typedef struct {
    int64_t row, sign;                     /* 0: its magnitude; 1 or -1: itself or its negative */
    int64_t ends;                          /* whether the trajectory ends at the limit */
    const double *limit;                   /* [n], or [1] with stride 0 */
    int64_t limit_stride;
    double *largest, *first;               /* [n]; first is infinite if the limit is not reached */
} watch_t;

typedef struct {
    int64_t n, max_steps, threads, n_times, n_watches;
    int64_t observed;                      /* whether any output is wanted between the steps */
    double t_end, tol;
    const double *const *x0;               /* [NS] initial states, each [n], or [1] with stride 0 */
    const int64_t *x0_stride;
    const double *const *p;                /* [NP] inputs, then parameters, likewise */
    const int64_t *p_stride;
    const signal_t *signals;               /* [NU] in place of the inputs, if VARYING */
    double *const *final;                  /* [NS], each [n] or NULL: states at the end */
    double *end;                           /* [n] time of the end */
    int8_t *cause;                         /* [n] index of the watch that ended it, or -1 */
    int8_t *status;                        /* [n] */
    int32_t *steps;                        /* [n] attempted steps */
    double *estimate;                      /* [n] estimated global error, relative to the scales */
    const double *times;                   /* [n_times] ascending, within 0..t_end */
    double *const *samples;                /* [ROWS], each [n][n_times] or NULL */
    const watch_t *watches;                /* [n_watches] */
} job_t;

/* ---- the model ---------------------------------------------------------------------------- */

/* State s, wherever it is carried; 0 if it is not, which nothing then depends on.  Those on which
 * rates depend are the first ND. */
#define PICK(x, s, i) ((s) >= 0 ? (x)[(s) >= 0 ? (s) : 0][i] : 0.0)
#define MOVE(x, s) ((s) < ND ? PICK(x, s, l) : 0.0)
#define WRITE(f, s, v) do { if ((s) >= 0) (f)[(s) >= 0 ? (s) : 0][l] = (v); } while (0)
#define WRITE_ENTRY(J, i, j, v) \
    do { if ((i) >= 0 && (j) >= 0 && (j) < ND) (J)[(i) >= 0 ? (i) : 0][(j) >= 0 ? (j) : 0][l] = (v); } while (0)
#define WRITE_MOVING(f, s, v) do { if ((s) < ND) WRITE(f, s, v); } while (0)

/* @MODEL@ */

/* ---- inputs over time ---------------------------------------------------------------------- */

#if VARYING
typedef struct {
    lanes row[NU1][1 + TERMS];             /* the polynomials that hold now */
    lanes until;                           /* when the first of them is followed by another */
    int64_t piece[NU1][LANES];
} inputs_t;

/* Put lane l on the polynomials that hold from t on, going forward from those that held before. */
static void enter(inputs_t *in, int l, const job_t *job, int64_t i, double t)
{
    in->until[l] = INFINITY;
    for (int j = 0; j < NU && !job->signals; ++j) {
        in->row[j][1][l] = job->p[j][i * job->p_stride[j]];
        for (int m = 2; m <= TERMS; ++m)
            in->row[j][m][l] = 0.0;
    }
    for (int j = 0; j < NU && job->signals; ++j) {
        const signal_t *s = &job->signals[j];
        const double *start = s->start + i * s->start_stride;
        int64_t k = in->piece[j][l];
        while (k + 1 < s->pieces && start[k + 1] <= t)
            ++k;
        in->piece[j][l] = k;
        if (k + 1 < s->pieces)
            in->until[l] = smaller(in->until[l], start[k + 1]);
        const double *value = s->value + i * s->value_stride + k * (1 + s->terms);
        for (int m = 0; m <= TERMS; ++m)
            in->row[j][m][l] = m <= s->terms ? value[m] : 0.0;
    }
}

/* Put lane l at the beginning. */
static void enter_first(inputs_t *in, int l, const job_t *job, int64_t i)
{
    for (int j = 0; j < NU; ++j)
        in->piece[j][l] = 0;
    enter(in, l, job, i, 0.0);
}

/* Most terms of any input. */
static int most_terms(const job_t *job)
{
    int64_t most = 1;
    for (int j = 0; j < NU && job->signals; ++j)
        most = job->signals[j].terms > most ? job->signals[j].terms : most;
    return (int)most;
}

/* Inputs of all lanes, each at its own time. */
static void inputs_at(const inputs_t *in, int terms, const double *t, lanes *u)
{
    for (int j = 0; j < NU; ++j) {
        LANE_LOOP u[j][l] = in->row[j][terms][l];
        for (int m = terms - 1; m > 0; --m)
            LANE_LOOP u[j][l] = in->row[j][m][l] + (t[l] - in->row[j][0][l]) * u[j][l];
    }
}

/* Inputs of one lane at many times. */
static void inputs_row(const inputs_t *in, int terms, int l, const double *t, double (*u)[TILE],
    int count)
{
    for (int j = 0; j < NU; ++j)
        for (int s = 0; s < count; ++s) {
            double value = in->row[j][terms][l];
            for (int m = terms - 1; m > 0; --m)
                value = in->row[j][m][l] + (t[s] - in->row[j][0][l]) * value;
            u[j][s] = value;
        }
}
#endif

#if DRIVER == 1
/* @ENSEMBLE@ */
#elif DRIVER == 2
/* @TRAJECTORY@ */
#endif
