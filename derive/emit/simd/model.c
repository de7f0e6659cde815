/* What every kernel of a model begins with; a driver follows. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = @LANES@ };
#define INLINE static inline __attribute__((always_inline))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* @ELEMENTARY@ */

/* @SIZES@ */
enum { ROWS = NS + NY };                     /* states, then outputs */
enum { TILE = 64, RETRIES = 4 };
enum { RUNNING = -1, OK = 0, NON_FINITE = 1, STEP_LIMIT = 2, UNSURE = 3, LEFT_RANGE = 4 };

static const double SCALE_FLOOR = 1e-6;    /* SI: a state's error is relative to at least this */
static const double FINEST = 2e-14;        /* local tolerance that rounding still allows */
static const double SHORTEST = 1e-12;      /* step / t_end at which a lane has got stuck */
static const double REST = 1e-9;           /* scales per t_end: slower than that is at rest */

typedef struct {
    int64_t n, max_steps, threads, n_times;
    int64_t observed;                      /* whether any output is wanted between the steps */
    double t_end, tol;
    const double *const *x0;               /* [NS] initial states, each [n], or [1] with stride 0 */
    const int64_t *x0_stride;
    const double *const *p;                /* [NP] inputs, then parameters, likewise */
    const int64_t *p_stride;
    double *const *final;                  /* [NS], each [n] or NULL */
    int8_t *status;                        /* [n] */
    int32_t *steps;                        /* [n] attempted steps */
    double *estimate;                      /* [n] estimated global error, relative to the scales */
    const double *times;                   /* [n_times] ascending, within 0..t_end */
    double *const *samples;                /* [ROWS], each [n][n_times] or NULL */
    const double *limit;                   /* [ROWS] whose first passing by |row| is looked for */
    const double *range;                   /* [ROWS] where |row| ends a trajectory */
    double *const *largest;                /* [ROWS], each [n] or NULL; NULL: none is watched */
    double *const *first;                  /* [ROWS], each [n] where largest is */
} job_t;

INLINE double larger(double a, double b) { return a > b ? a : b; }
INLINE double smaller(double a, double b) { return a < b ? a : b; }

/* @MODEL@ */

/* @DRIVER@ */
