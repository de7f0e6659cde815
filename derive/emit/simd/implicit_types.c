/* Rodas5P: a Rosenbrock method of eight stages and fifth order, L-stable and stiffly accurate
 * (Steinebach, BIT Numer. Math. 63, 2023, 27).  Each step solves linear systems with the Jacobian,
 * so that what is fast and dies out does not limit it. */
enum { STAGES = 8, KEPT_STAGES = 8, DENSE_TERMS = 3, ORDER = 5 };

static const double SHARE = @SHARE@;       /* local tolerance tau / tol */
static const double TRUST = 0.5;           /* estimated global error / tol that is accepted */
static const double GAMMA = @GAMMA@;
static const double DELTA = 1e-4;          /* part of a step over which inputs are differenced */

typedef struct {
    lanes jacobian[NS][ND1], lu[ND1][ND1], right[NS], slope[NS], local;
    lanes h_before, e_before;              /* of the last step that was accepted; 0 after a failure */
} method_t;

typedef struct { lanes e[NS], doubt; } errors_t;
