/* DOP853: Dormand and Prince's eighth-order pair, with Hairer's error estimates and dense output. */
enum { STAGES = 12, KEPT_STAGES = 16, DENSE_TERMS = 7, ORDER = 8 };

static const double SHARE = 0.2;           /* local tolerance tau / tol */
static const double TRUST = 0.5;           /* estimated global error / tol that is accepted */
static const double REACH = 10.5, HOLD = 0.97;  /* see cap() */
static const double GUARD = 0.7;           /* see measure() */
static const double BETWEEN = 0.003;       /* see measure_between() */

typedef struct {
    lanes e5[NS], e3[NS], mode[ND1], growth, rho, reach, local, sharp, head, tail;
} method_t;

/* What is followed of the global error, see below. */
#if PLANE && !VARYING
typedef struct { lanes drift, past[NS], past2[NS], area, passed, spread, shift, doubt, trace; } errors_t;
#else
typedef struct { lanes e[NS], image[NS], mode[ND1], turn[ND1], doubt; } errors_t;
#endif
