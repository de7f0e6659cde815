/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* What every kernel of a model begins with; a driver follows. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 32 };
#define INLINE static inline __attribute__((always_inline))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* ---- elementary functions, branch-free so that loops over lanes become vector code ---------
 * Errors below 2.3 units of the last place (tan: 4), measured.  NaN in, NaN out. */

INLINE int64_t bits(double x) { int64_t b; memcpy(&b, &x, sizeof b); return b; }
INLINE double from_bits(int64_t b) { double x; memcpy(&x, &b, sizeof x); return x; }

/* x where the mask is -1, 0 where it is 0.  Masks, because gcc takes ?: apart into paths and puts
 * them together again with one division for each path. */
INLINE double only(int64_t mask, double x) { return from_bits(mask & bits(x)); }

/* t of lane_atan and the angle to add. */
INLINE double fold(double z, double *offset)
{
    const int64_t mid = -(int64_t)(z > 0.41421356237309503), big = -(int64_t)(z > 2.414213562373095);
    *offset = only(mid, 0.7853981633974483) + only(big, 0.7853981633974483);
    return (only(~big, z) - only(mid, 1.0)) / (only(~big, 1.0) + only(mid, z));
}

/* atan: |x| to t in [-tan(pi/8), tan(pi/8)] by t = z, (z - 1) / (z + 1) or -1 / z, then
 * t + t s P(s) with s = t t. */
INLINE double lane_atan(double x)
{
    double offset;
    const double t = fold(fabs(x), &offset), s = t * t, s2 = s * s;
    const double p = (-0.3333333333333015 + s2 * (-0.14285714195261148 + s2 * (-0.09090782412337584 + s2 * (-0.06641121186601258 + s2 * -0.04359095370168373)))) + s * (0.19999999999088952 + s2 * (0.11111106653580938 + s2 * (0.07690068299297602 + s2 * (0.05692538997871437 + s2 * 0.021259847052258217))));
    return copysign(offset + (t + t * s * p), x);
}

/* (-1)^k sin(x - n pi), n = k + shift, k = round(x / pi - shift): sine with shift 0, cosine 1/2.
 * Three-part Cody-Waite reduction, good to |x| = 1.6e6; beyond that NaN, not wrong
 * digits. */
INLINE double lane_wave(double x, double shift)
{
    const double magic = 6755399441055744.0;    /* 1.5 * 2^52: adding it rounds to a whole number */
    const double rounded = x * 0.3183098861837907 - shift + magic, n = rounded - magic + shift;
    const double r0 = ((x - n * 3.1415926534682512) - n * 1.2154201012607932e-10) - n * 4.044532497591901e-21;
    const double r = from_bits(bits(r0) | -(int64_t)!(fabs(x) < 1.6e6));
    const double s = r * r, s2 = s * s;
    const double p = (-0.16666666666666666 + s2 * (-0.0001984126984120885 + s2 * (-2.5052106866687343e-08 + s2 * -7.642983119287835e-13))) + s * (0.008333333333333193 + s2 * (2.755731921107215e-06 + s2 * (1.6058939391233316e-10 + s2 * 2.721085003160315e-15)));
    return from_bits(bits(r + r * s * p) ^ (int64_t)((uint64_t)bits(rounded) << 63));
}

INLINE double lane_sin(double x) { return lane_wave(x, 0.0); }
INLINE double lane_cos(double x) { return -lane_wave(x, 0.5); }
INLINE double lane_tan(double x) { return lane_sin(x) / lane_cos(x); }

/* Minimum and maximum that let NaN through, unlike fmin and fmax. */
INLINE double lane_min(double a, double b) { return a < b ? a : (b <= a ? b : a + b); }
INLINE double lane_max(double a, double b) { return a > b ? a : (b >= a ? b : a + b); }
INLINE double lane_sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }


enum { NS = 4, ND = 2, NP = 20, NC = 43, NW = 10, NY = 11, NY1 = 11 };
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

static void constants(const lanes *p, lanes *c)
{
    LANE_LOOP {
        const double w0 = p[12][l] * p[10][l];
        const double w1 = p[11][l] + w0;
        const double w2 = p[14][l] * p[10][l];
        const double w3 = p[13][l] + w2;
        const double w4 = w3 * p[5][l];
        const double w5 = 1.0 / w4;
        const double w6 = w5 * w1;
        const double w7 = -p[18][l];
        const double w8 = 1.0 + w7;
        const double w9 = w8 * w6;
        const double w10 = p[15][l] * w6;
        const double w11 = 1.0 / p[15][l];
        const double w12 = w11 * p[18][l];
        const double w13 = p[10][l] * p[17][l];
        const double w14 = w3 * w13;
        const double w15 = 2.0 * w14;
        const double w16 = -w15;
        const double w17 = 0.5 * p[7][l];
        const double w18 = w17 * p[8][l];
        const double w19 = -p[4][l];
        const double w20 = 1.0 / p[5][l];
        const double w21 = p[6][l] * w18;
        const double w22 = p[5][l] * p[5][l];
        const double w23 = w22 * w21;
        const double w24 = -w23;
        const double w25 = -p[9][l];
        const double w26 = w24 + w25;
        const double w27 = 1.0 / p[1][l];
        const double w28 = -p[5][l];
        const double w29 = w27 * w16;
        const double w30 = w27 * w26;
        const double w31 = w27 * p[0][l];
        const double w32 = p[4][l] * w23;
        const double w33 = p[0][l] * p[4][l];
        const double w34 = p[3][l] * w15;
        const double w35 = -w34;
        const double w36 = -w33;
        const double w37 = p[4][l] * p[9][l];
        const double w38 = w32 + w37;
        const double w39 = 1.0 / p[2][l];
        const double w40 = w39 * w38;
        const double w41 = w39 * w35;
        const double w42 = w39 * w36;
        const double w43 = w1 * w20;
        const double w44 = 1.0 / w3;
        const double w45 = w44 * w43;
        const double w46 = w8 * w45;
        const double w47 = p[15][l] * w45;
        const double w48 = -p[1][l];
        const double w49 = p[19][l] * p[1][l];
        const double w50 = w10 * w10;
        const double w51 = p[18][l] * w10;
        const double w52 = w11 * w51;
        const double w53 = p[15][l] * p[15][l];
        const double w54 = p[16][l] * p[15][l];
        const double w55 = p[17][l] * w54;
        const double w56 = p[10][l] * w55;
        const double w57 = w3 * w56;
        const double w58 = 2.0 * w57;
        const double w59 = w20 * w20;
        const double w60 = w18 * w20;
        const double w61 = p[6][l] * w60;
        const double w62 = w22 * w61;
        const double w63 = p[9][l] * w20;
        const double w64 = w62 + w63;
        const double w65 = w27 * w58;
        const double w66 = w27 * w64;
        const double w67 = -w65;
        const double w68 = -w66;
        const double w69 = p[4][l] * w62;
        const double w70 = p[3][l] * w58;
        const double w71 = -w70;
        const double w72 = p[4][l] * w63;
        const double w73 = w69 + w72;
        const double w74 = w39 * w73;
        const double w75 = w39 * w71;
        const double w76 = w1 / w4;
        const double w77 = w8 * w76;
        const double w78 = p[15][l] * w76;
        const double w79 = p[18][l] * w78;
        const double w80 = w11 * w79;
        const double w81 = p[4][l] / p[5][l];
        const double w82 = w18 * w81;
        const double w83 = p[6][l] * w82;
        const double w84 = w22 * w83;
        const double w85 = p[4][l] * w84;
        const double w86 = w1 * p[3][l];
        const double w87 = w86 / w4;
        const double w88 = w8 * w87;
        const double w89 = p[15][l] * w87;
        const double w90 = p[18][l] * w89;
        const double w91 = w11 * w90;
        const double w92 = p[9][l] * w81;
        const double w93 = p[4][l] * w92;
        const double w94 = w85 + w93;
        const double w95 = w39 * w94;
        const double w96 = w66 + w95;
        const double w97 = w39 * w70;
        const double w98 = -w96;
        const double w99 = -w97;
        c[0][l] = p[0][l];
        c[1][l] = p[3][l];
        c[2][l] = p[9][l];
        c[3][l] = p[15][l];
        c[4][l] = p[16][l];
        c[5][l] = w9;
        c[6][l] = w10;
        c[7][l] = w12;
        c[8][l] = w15;
        c[9][l] = w16;
        c[10][l] = w19;
        c[11][l] = w20;
        c[12][l] = w23;
        c[13][l] = w26;
        c[14][l] = w27;
        c[15][l] = w28;
        c[16][l] = w29;
        c[17][l] = w30;
        c[18][l] = w31;
        c[19][l] = w35;
        c[20][l] = w36;
        c[21][l] = w38;
        c[22][l] = w40;
        c[23][l] = w41;
        c[24][l] = w42;
        c[25][l] = w46;
        c[26][l] = w47;
        c[27][l] = w48;
        c[28][l] = w49;
        c[29][l] = w50;
        c[30][l] = w52;
        c[31][l] = w53;
        c[32][l] = w59;
        c[33][l] = w67;
        c[34][l] = w68;
        c[35][l] = w74;
        c[36][l] = w75;
        c[37][l] = w77;
        c[38][l] = w80;
        c[39][l] = w88;
        c[40][l] = w91;
        c[41][l] = w98;
        c[42][l] = w99;
    }
}

INLINE void rate0(const lanes *c, lanes *w, lanes *f, lanes *g, int l, double x0, double x1)
{
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[6][l] * w1;
    const double w3 = lane_atan(w2);
    const double w4 = c[5][l] * w1;
    const double w5 = c[7][l] * w3;
    const double w6 = w4 + w5;
    const double w7 = c[3][l] * w6;
    const double w8 = c[10][l] * x1;
    const double w9 = x0 + w8;
    const double w10 = c[11][l] * w9;
    const double w11 = lane_atan(w10);
    const double w12 = c[15][l] * x1;
    const double w13 = w12 + c[18][l];
    const double w14 = c[17][l] * w11;
    const double w15 = w13 + w14;
    const double w16 = c[22][l] * w11;
    const double w17 = w16 + c[24][l];
    w[0][l] = w7;
    w[2][l] = w15;
    w[3][l] = w17;
    f[2][l] = x0;
    f[3][l] = x1;
}

INLINE void rate1(const lanes *c, lanes *w, lanes *f, lanes *g, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[4][l] * w0;
    w[1][l] = w1;
}

INLINE void rate2(const lanes *c, lanes *w, lanes *f, lanes *g, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[16][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[23][l] * w0;
    const double w4 = w[3][l] + w3;
    f[0][l] = w2;
    f[1][l] = w4;
}

INLINE void turn0(const lanes *c, lanes *w, lanes *f, lanes *g, int l, double x0, double x1, double d0, double d1)
{
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[6][l] * w1;
    const double w3 = lane_atan(w2);
    const double w4 = c[5][l] * w1;
    const double w5 = c[7][l] * w3;
    const double w6 = w4 + w5;
    const double w7 = c[3][l] * w6;
    const double w8 = c[10][l] * x1;
    const double w9 = x0 + w8;
    const double w10 = c[11][l] * w9;
    const double w11 = lane_atan(w10);
    const double w12 = c[15][l] * x1;
    const double w13 = w12 + c[18][l];
    const double w14 = c[17][l] * w11;
    const double w15 = w13 + w14;
    const double w16 = c[22][l] * w11;
    const double w17 = w16 + c[24][l];
    const double w18 = c[1][l] * d1;
    const double w19 = d0 + w18;
    const double w20 = w1 * w1;
    const double w21 = c[29][l] * w20;
    const double w22 = w21 + 1.0;
    const double w23 = 1.0 / w22;
    const double w24 = w19 * w23;
    const double w25 = w6 * w6;
    const double w26 = c[31][l] * w25;
    const double w27 = w26 + 1.0;
    const double w28 = 1.0 / w27;
    const double w29 = c[5][l] * w19;
    const double w30 = c[30][l] * w24;
    const double w31 = w29 + w30;
    const double w32 = w31 * w28;
    const double w33 = w9 * w9;
    const double w34 = c[32][l] * w33;
    const double w35 = w34 + 1.0;
    const double w36 = 1.0 / w35;
    const double w37 = c[10][l] * d1;
    const double w38 = d0 + w37;
    const double w39 = w38 * w36;
    const double w40 = c[15][l] * d1;
    const double w41 = c[34][l] * w39;
    const double w42 = w40 + w41;
    const double w43 = c[35][l] * w39;
    const double w44 = c[38][l] * w23;
    const double w45 = w44 + c[37][l];
    const double w46 = w45 * w28;
    const double w47 = c[40][l] * w23;
    const double w48 = w47 + c[39][l];
    const double w49 = w48 * w28;
    const double w50 = c[41][l] * w36;
    w[0][l] = w7;
    w[2][l] = w15;
    w[3][l] = w17;
    w[4][l] = w32;
    w[5][l] = w42;
    w[6][l] = w43;
    w[7][l] = w46;
    w[8][l] = w49;
    w[9][l] = w50;
    f[2][l] = x0;
    f[3][l] = x1;
}

INLINE void turn1(const lanes *c, lanes *w, lanes *f, lanes *g, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[4][l] * w0;
    w[1][l] = w1;
}

INLINE void turn2(const lanes *c, lanes *w, lanes *f, lanes *g, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[16][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[23][l] * w0;
    const double w4 = w[3][l] + w3;
    const double w5 = lane_cos(w[1][l]);
    const double w6 = w5 * w[4][l];
    const double w7 = c[33][l] * w6;
    const double w8 = w[5][l] + w7;
    const double w9 = c[36][l] * w6;
    const double w10 = w[6][l] + w9;
    const double w11 = w5 * w[7][l];
    const double w12 = w5 * w[8][l];
    const double w13 = c[33][l] * w11;
    const double w14 = w[9][l] + w13;
    const double w15 = c[42][l] * w12;
    const double w16 = w14 + w15;
    f[0][l] = w2;
    f[1][l] = w4;
    g[0][l] = w8;
    g[1][l] = w10;
    g[2][l] = w16;
}

static void rates(const lanes *c, lanes *w, const lanes *x, lanes *f)
{
    LANE_LOOP {
        rate0(c, w, f, f, l, x[0][l], x[1][l]);
    }
    LANE_LOOP rate1(c, w, f, f, l);
    LANE_LOOP rate2(c, w, f, f, l);
}

INLINE void output(const lanes *c, int l, double x0, double x1, double x2, double x3, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10)
{
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[10][l] * x1;
    const double w3 = x0 + w2;
    const double w4 = c[11][l] * w3;
    const double w5 = lane_atan(w4);
    const double w6 = c[11][l] * w1;
    const double w7 = lane_atan(w6);
    const double w8 = c[11][l] * x0;
    const double w9 = lane_atan(w8);
    const double w10 = c[26][l] * w1;
    const double w11 = lane_atan(w10);
    const double w12 = c[25][l] * w1;
    const double w13 = c[7][l] * w11;
    const double w14 = w12 + w13;
    const double w15 = c[3][l] * w14;
    const double w16 = lane_atan(w15);
    const double w17 = c[4][l] * w16;
    const double w18 = lane_sin(w17);
    const double w19 = c[8][l] * w18;
    const double w20 = c[12][l] * w5;
    const double w21 = c[2][l] * w5;
    const double w22 = c[13][l] * w5;
    const double w23 = w22 + c[0][l];
    const double w24 = c[9][l] * w18;
    const double w25 = w23 + w24;
    const double w26 = c[14][l] * w25;
    const double w27 = c[21][l] * w5;
    const double w28 = w27 + c[20][l];
    const double w29 = c[19][l] * w18;
    const double w30 = w28 + w29;
    const double w31 = x1 * x0;
    const double w32 = c[27][l] * w31;
    *y0 = w7;
    *y1 = w5;
    *y2 = w9;
    *y3 = w19;
    *y4 = w20;
    *y5 = w21;
    *y6 = w26;
    *y7 = w25;
    *y8 = w30;
    *y9 = w32;
    *y10 = c[28][l];
}

static void observe_lanes(const lanes *c, const lanes *x, lanes *y)
{
    LANE_LOOP {
        output(c, l, x[0][l], x[1][l], x[2][l], x[3][l], &y[0][l], &y[1][l], &y[2][l], &y[3][l], &y[4][l], &y[5][l], &y[6][l], &y[7][l], &y[8][l], &y[9][l], &y[10][l]);
    }
}

static void observe_row(const lanes *c, int l, double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, x[0][s], x[1][s], x[2][s], x[3][s], &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s]);
}


/* Many trajectories side by side: DOP853, every lane with its own time, step and tolerance.
 *
 * A block holds LANES trajectories as structure of arrays; every loop over lanes is a vector
 * loop.  A lane that has reached the end is written out and loaded with the next trajectory, so
 * no lane waits for a slower neighbour.  A lane never reads another lane: a result does not
 * depend on the number of threads, on the order, or on the company a trajectory keeps.
 *
 * Never build with -ffast-math: it hides NaN and shares rounding errors between lanes.
 */
enum { STAGES = 12, DENSE_STAGES = 16, DENSE_TERMS = 7, NODES = 8 };

static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 6.0;
static const double SHARE = 0.2;           /* local tolerance tau / tol */
static const double TRUST = 1.0;           /* estimated global error / tol that is accepted */
static const double REACH = 10.5, HOLD = 0.97;  /* see cap() */
static const double GUARD = 0.7;           /* see measure() */
static const double ACROSS = 0.3;          /* see follow_error() */
static const double BETWEEN = 0.003;       /* see measure_between() */

typedef struct {
    lanes c[NC], w[NW], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS], e5[NS], e3[NS];
    lanes k[DENSE_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1], largest[ROWS], first[ROWS];
    lanes mode[NS], turn[NS + 1], growth, rho, reach, t, h, h0, least, tau, error, local, head, tail;
    lanes drift, past[NS], past2[NS], area, passed, spread, shift, doubt;
    lanes steps, state, theta;
    int64_t id[LANES], next[LANES];
    int retries[LANES];
} __attribute__((aligned(64))) block_t;

/* Trajectories ready to be loaded into lanes. */
typedef struct {
    lanes p[NP], c[NC], w[NW], x[NS], xn[NS], k[2][NS], h;
    int64_t id;
    int used, count, filled;               /* filled: numbers that all share are there */
} __attribute__((aligned(64))) queue_t;

/* ---- step control ------------------------------------------------------------------------ */

/* Keep the step within REACH tau^(1/12) / |largest eigenvalue|.  Near the edge of stability the
 * fast modes that have died out make the error estimate blind, now and then by a factor of a
 * hundred.  The eigenvalue comes from a power iteration that makes one turn a step:
 * turn = J mode. */
static void cap(block_t *b)
{
    lanes size, grown;
    LANE_LOOP size[l] = grown[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l];
            size[l] = larger(size[l], w * fabs(b->mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(b->turn[j][l]));
        }
    LANE_LOOP {
        const double growth = grown[l] / (size[l] + DBL_MIN);
        const double mean = sqrt(growth * b->growth[l]);
        const double rho = larger(mean, HOLD * b->rho[l]), h = b->h[l];
        b->growth[l] = growth;
        b->rho[l] = rho;
        b->h[l] = h * rho > b->reach[l] ? b->reach[l] / rho : h;
        size[l] = growth > 0.0 ? 1.0 / grown[l] : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->mode[j][l] = size[l] > 0.0 ? b->turn[j][l] * size[l] : b->mode[j][l];
}

static void stage0(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l];
        const double x1 = b->x[1][l];
        turn0(b->c, b->w, b->k[0], b->turn, l, x0, x1, b->mode[0][l], b->mode[1][l]);
    }
    LANE_LOOP turn1(b->c, b->w, b->k[0], b->turn, l);
    LANE_LOOP turn2(b->c, b->w, b->k[0], b->turn, l);
}

static void stage1(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.05260015195876773 * b->k[0][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.05260015195876773 * b->k[0][1][l]);
        rate0(b->c, b->w, b->k[1], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[1], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[1], b->turn, l);
}

static void stage2(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.0197250569845379 * b->k[0][0][l] + 0.0591751709536137 * b->k[1][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.0197250569845379 * b->k[0][1][l] + 0.0591751709536137 * b->k[1][1][l]);
        rate0(b->c, b->w, b->k[2], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[2], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[2], b->turn, l);
}

static void stage3(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.02958758547680685 * b->k[0][0][l] + 0.08876275643042054 * b->k[2][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.02958758547680685 * b->k[0][1][l] + 0.08876275643042054 * b->k[2][1][l]);
        rate0(b->c, b->w, b->k[3], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[3], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[3], b->turn, l);
}

static void stage4(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.2413651341592667 * b->k[0][0][l] + -0.8845494793282861 * b->k[2][0][l] + 0.924834003261792 * b->k[3][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.2413651341592667 * b->k[0][1][l] + -0.8845494793282861 * b->k[2][1][l] + 0.924834003261792 * b->k[3][1][l]);
        rate0(b->c, b->w, b->k[4], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[4], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[4], b->turn, l);
}

static void stage5(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.037037037037037035 * b->k[0][0][l] + 0.17082860872947386 * b->k[3][0][l] + 0.12546768756682242 * b->k[4][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.037037037037037035 * b->k[0][1][l] + 0.17082860872947386 * b->k[3][1][l] + 0.12546768756682242 * b->k[4][1][l]);
        rate0(b->c, b->w, b->k[5], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[5], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[5], b->turn, l);
}

static void stage6(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.037109375 * b->k[0][0][l] + 0.17025221101954405 * b->k[3][0][l] + 0.06021653898045596 * b->k[4][0][l] + -0.017578125 * b->k[5][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.037109375 * b->k[0][1][l] + 0.17025221101954405 * b->k[3][1][l] + 0.06021653898045596 * b->k[4][1][l] + -0.017578125 * b->k[5][1][l]);
        rate0(b->c, b->w, b->k[6], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[6], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[6], b->turn, l);
}

static void stage7(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.03709200011850479 * b->k[0][0][l] + 0.17038392571223998 * b->k[3][0][l] + 0.10726203044637328 * b->k[4][0][l] + -0.015319437748624402 * b->k[5][0][l] + 0.008273789163814023 * b->k[6][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.03709200011850479 * b->k[0][1][l] + 0.17038392571223998 * b->k[3][1][l] + 0.10726203044637328 * b->k[4][1][l] + -0.015319437748624402 * b->k[5][1][l] + 0.008273789163814023 * b->k[6][1][l]);
        rate0(b->c, b->w, b->k[7], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[7], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[7], b->turn, l);
}

static void stage8(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.6241109587160757 * b->k[0][0][l] + -3.3608926294469414 * b->k[3][0][l] + -0.868219346841726 * b->k[4][0][l] + 27.59209969944671 * b->k[5][0][l] + 20.154067550477894 * b->k[6][0][l] + -43.48988418106996 * b->k[7][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.6241109587160757 * b->k[0][1][l] + -3.3608926294469414 * b->k[3][1][l] + -0.868219346841726 * b->k[4][1][l] + 27.59209969944671 * b->k[5][1][l] + 20.154067550477894 * b->k[6][1][l] + -43.48988418106996 * b->k[7][1][l]);
        rate0(b->c, b->w, b->k[8], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[8], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[8], b->turn, l);
}

static void stage9(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.47766253643826434 * b->k[0][0][l] + -2.4881146199716677 * b->k[3][0][l] + -0.590290826836843 * b->k[4][0][l] + 21.230051448181193 * b->k[5][0][l] + 15.279233632882423 * b->k[6][0][l] + -33.28821096898486 * b->k[7][0][l] + -0.020331201708508627 * b->k[8][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.47766253643826434 * b->k[0][1][l] + -2.4881146199716677 * b->k[3][1][l] + -0.590290826836843 * b->k[4][1][l] + 21.230051448181193 * b->k[5][1][l] + 15.279233632882423 * b->k[6][1][l] + -33.28821096898486 * b->k[7][1][l] + -0.020331201708508627 * b->k[8][1][l]);
        rate0(b->c, b->w, b->k[9], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[9], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[9], b->turn, l);
}

static void stage10(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (-0.9371424300859873 * b->k[0][0][l] + 5.186372428844064 * b->k[3][0][l] + 1.0914373489967295 * b->k[4][0][l] + -8.149787010746927 * b->k[5][0][l] + -18.52006565999696 * b->k[6][0][l] + 22.739487099350505 * b->k[7][0][l] + 2.4936055526796523 * b->k[8][0][l] + -3.0467644718982196 * b->k[9][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (-0.9371424300859873 * b->k[0][1][l] + 5.186372428844064 * b->k[3][1][l] + 1.0914373489967295 * b->k[4][1][l] + -8.149787010746927 * b->k[5][1][l] + -18.52006565999696 * b->k[6][1][l] + 22.739487099350505 * b->k[7][1][l] + 2.4936055526796523 * b->k[8][1][l] + -3.0467644718982196 * b->k[9][1][l]);
        rate0(b->c, b->w, b->k[10], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[10], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[10], b->turn, l);
}

static void stage11(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (2.273310147516538 * b->k[0][0][l] + -10.53449546673725 * b->k[3][0][l] + -2.0008720582248625 * b->k[4][0][l] + -17.9589318631188 * b->k[5][0][l] + 27.94888452941996 * b->k[6][0][l] + -2.8589982771350235 * b->k[7][0][l] + -8.87285693353063 * b->k[8][0][l] + 12.360567175794303 * b->k[9][0][l] + 0.6433927460157636 * b->k[10][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (2.273310147516538 * b->k[0][1][l] + -10.53449546673725 * b->k[3][1][l] + -2.0008720582248625 * b->k[4][1][l] + -17.9589318631188 * b->k[5][1][l] + 27.94888452941996 * b->k[6][1][l] + -2.8589982771350235 * b->k[7][1][l] + -8.87285693353063 * b->k[8][1][l] + 12.360567175794303 * b->k[9][1][l] + 0.6433927460157636 * b->k[10][1][l]);
        rate0(b->c, b->w, b->k[11], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[11], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[11], b->turn, l);
}

static void attempt(block_t *b)
{
    stage0(b);
    cap(b);
    stage1(b);
    stage2(b);
    stage3(b);
    stage4(b);
    stage5(b);
    stage6(b);
    stage7(b);
    stage8(b);
    stage9(b);
    stage10(b);
    stage11(b);
    LANE_LOOP {
        b->xn[0][l] = b->x[0][l] + b->h[l] * (0.054293734116568765 * b->k[0][0][l] + 4.450312892752409 * b->k[5][0][l] + 1.8915178993145003 * b->k[6][0][l] + -5.801203960010585 * b->k[7][0][l] + 0.3111643669578199 * b->k[8][0][l] + -0.1521609496625161 * b->k[9][0][l] + 0.20136540080403034 * b->k[10][0][l] + 0.04471061572777259 * b->k[11][0][l]);
        b->e5[0][l] = 0.01312004499419488 * b->k[0][0][l] + -1.2251564463762044 * b->k[5][0][l] + -0.4957589496572502 * b->k[6][0][l] + 1.6643771824549864 * b->k[7][0][l] + -0.35032884874997366 * b->k[8][0][l] + 0.3341791187130175 * b->k[9][0][l] + 0.08192320648511571 * b->k[10][0][l] + -0.022355307863886294 * b->k[11][0][l];
        b->e3[0][l] = -0.18980075407240762 * b->k[0][0][l] + 4.450312892752409 * b->k[5][0][l] + 1.8915178993145003 * b->k[6][0][l] + -5.801203960010585 * b->k[7][0][l] + -0.4226823213237919 * b->k[8][0][l] + -0.1521609496625161 * b->k[9][0][l] + 0.20136540080403034 * b->k[10][0][l] + 0.02265179219836082 * b->k[11][0][l];
    }
    LANE_LOOP {
        b->xn[1][l] = b->x[1][l] + b->h[l] * (0.054293734116568765 * b->k[0][1][l] + 4.450312892752409 * b->k[5][1][l] + 1.8915178993145003 * b->k[6][1][l] + -5.801203960010585 * b->k[7][1][l] + 0.3111643669578199 * b->k[8][1][l] + -0.1521609496625161 * b->k[9][1][l] + 0.20136540080403034 * b->k[10][1][l] + 0.04471061572777259 * b->k[11][1][l]);
        b->e5[1][l] = 0.01312004499419488 * b->k[0][1][l] + -1.2251564463762044 * b->k[5][1][l] + -0.4957589496572502 * b->k[6][1][l] + 1.6643771824549864 * b->k[7][1][l] + -0.35032884874997366 * b->k[8][1][l] + 0.3341791187130175 * b->k[9][1][l] + 0.08192320648511571 * b->k[10][1][l] + -0.022355307863886294 * b->k[11][1][l];
        b->e3[1][l] = -0.18980075407240762 * b->k[0][1][l] + 4.450312892752409 * b->k[5][1][l] + 1.8915178993145003 * b->k[6][1][l] + -5.801203960010585 * b->k[7][1][l] + -0.4226823213237919 * b->k[8][1][l] + -0.1521609496625161 * b->k[9][1][l] + 0.20136540080403034 * b->k[10][1][l] + 0.02265179219836082 * b->k[11][1][l];
    }
    LANE_LOOP {
        b->xn[2][l] = b->x[2][l] + b->h[l] * (0.054293734116568765 * b->k[0][2][l] + 4.450312892752409 * b->k[5][2][l] + 1.8915178993145003 * b->k[6][2][l] + -5.801203960010585 * b->k[7][2][l] + 0.3111643669578199 * b->k[8][2][l] + -0.1521609496625161 * b->k[9][2][l] + 0.20136540080403034 * b->k[10][2][l] + 0.04471061572777259 * b->k[11][2][l]);
        b->e5[2][l] = 0.01312004499419488 * b->k[0][2][l] + -1.2251564463762044 * b->k[5][2][l] + -0.4957589496572502 * b->k[6][2][l] + 1.6643771824549864 * b->k[7][2][l] + -0.35032884874997366 * b->k[8][2][l] + 0.3341791187130175 * b->k[9][2][l] + 0.08192320648511571 * b->k[10][2][l] + -0.022355307863886294 * b->k[11][2][l];
        b->e3[2][l] = -0.18980075407240762 * b->k[0][2][l] + 4.450312892752409 * b->k[5][2][l] + 1.8915178993145003 * b->k[6][2][l] + -5.801203960010585 * b->k[7][2][l] + -0.4226823213237919 * b->k[8][2][l] + -0.1521609496625161 * b->k[9][2][l] + 0.20136540080403034 * b->k[10][2][l] + 0.02265179219836082 * b->k[11][2][l];
    }
    LANE_LOOP {
        b->xn[3][l] = b->x[3][l] + b->h[l] * (0.054293734116568765 * b->k[0][3][l] + 4.450312892752409 * b->k[5][3][l] + 1.8915178993145003 * b->k[6][3][l] + -5.801203960010585 * b->k[7][3][l] + 0.3111643669578199 * b->k[8][3][l] + -0.1521609496625161 * b->k[9][3][l] + 0.20136540080403034 * b->k[10][3][l] + 0.04471061572777259 * b->k[11][3][l]);
        b->e5[3][l] = 0.01312004499419488 * b->k[0][3][l] + -1.2251564463762044 * b->k[5][3][l] + -0.4957589496572502 * b->k[6][3][l] + 1.6643771824549864 * b->k[7][3][l] + -0.35032884874997366 * b->k[8][3][l] + 0.3341791187130175 * b->k[9][3][l] + 0.08192320648511571 * b->k[10][3][l] + -0.022355307863886294 * b->k[11][3][l];
        b->e3[3][l] = -0.18980075407240762 * b->k[0][3][l] + 4.450312892752409 * b->k[5][3][l] + 1.8915178993145003 * b->k[6][3][l] + -5.801203960010585 * b->k[7][3][l] + -0.4226823213237919 * b->k[8][3][l] + -0.1521609496625161 * b->k[9][3][l] + 0.20136540080403034 * b->k[10][3][l] + 0.02265179219836082 * b->k[11][3][l];
    }
}

static void stage12(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->xn[0][l];
        const double x1 = b->xn[1][l];
        rate0(b->c, b->w, b->k[12], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[12], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[12], b->turn, l);
}

static void stage13(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.056167502283047954 * b->k[0][0][l] + 0.25350021021662483 * b->k[6][0][l] + -0.2462390374708025 * b->k[7][0][l] + -0.12419142326381637 * b->k[8][0][l] + 0.15329179827876568 * b->k[9][0][l] + 0.00820105229563469 * b->k[10][0][l] + 0.007567897660545699 * b->k[11][0][l] + -0.008298 * b->k[12][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.056167502283047954 * b->k[0][1][l] + 0.25350021021662483 * b->k[6][1][l] + -0.2462390374708025 * b->k[7][1][l] + -0.12419142326381637 * b->k[8][1][l] + 0.15329179827876568 * b->k[9][1][l] + 0.00820105229563469 * b->k[10][1][l] + 0.007567897660545699 * b->k[11][1][l] + -0.008298 * b->k[12][1][l]);
        rate0(b->c, b->w, b->k[13], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[13], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[13], b->turn, l);
}

static void stage14(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (0.03183464816350214 * b->k[0][0][l] + 0.028300909672366776 * b->k[5][0][l] + 0.053541988307438566 * b->k[6][0][l] + -0.05492374857139099 * b->k[7][0][l] + -0.00010834732869724932 * b->k[10][0][l] + 0.0003825710908356584 * b->k[11][0][l] + -0.00034046500868740456 * b->k[12][0][l] + 0.1413124436746325 * b->k[13][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (0.03183464816350214 * b->k[0][1][l] + 0.028300909672366776 * b->k[5][1][l] + 0.053541988307438566 * b->k[6][1][l] + -0.05492374857139099 * b->k[7][1][l] + -0.00010834732869724932 * b->k[10][1][l] + 0.0003825710908356584 * b->k[11][1][l] + -0.00034046500868740456 * b->k[12][1][l] + 0.1413124436746325 * b->k[13][1][l]);
        rate0(b->c, b->w, b->k[14], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[14], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[14], b->turn, l);
}

static void stage15(block_t *b)
{
    LANE_LOOP {
        const double x0 = b->x[0][l] + b->h[l] * (-0.42889630158379194 * b->k[0][0][l] + -4.697621415361164 * b->k[5][0][l] + 7.683421196062599 * b->k[6][0][l] + 4.06898981839711 * b->k[7][0][l] + 0.3567271874552811 * b->k[8][0][l] + -0.0013990241651590145 * b->k[12][0][l] + 2.9475147891527724 * b->k[13][0][l] + -9.15095847217987 * b->k[14][0][l]);
        const double x1 = b->x[1][l] + b->h[l] * (-0.42889630158379194 * b->k[0][1][l] + -4.697621415361164 * b->k[5][1][l] + 7.683421196062599 * b->k[6][1][l] + 4.06898981839711 * b->k[7][1][l] + 0.3567271874552811 * b->k[8][1][l] + -0.0013990241651590145 * b->k[12][1][l] + 2.9475147891527724 * b->k[13][1][l] + -9.15095847217987 * b->k[14][1][l]);
        rate0(b->c, b->w, b->k[15], b->turn, l, x0, x1);
    }
    LANE_LOOP rate1(b->c, b->w, b->k[15], b->turn, l);
    LANE_LOOP rate2(b->c, b->w, b->k[15], b->turn, l);
}

static void prepare_dense(block_t *b)
{
    stage12(b);
    stage13(b);
    stage14(b);
    stage15(b);
    LANE_LOOP {
        const double h = b->h[l], move = b->xn[0][l] - b->x[0][l];
        const double slope = h * b->k[0][0][l];
        b->d[0][0][l] = move;
        b->d[1][0][l] = slope - move;
        b->d[2][0][l] = 2.0 * move - (h * b->k[12][0][l] + slope);
        b->d[3][0][l] = h * (-8.428938276109013 * b->k[0][0][l] + 0.5667149535193777 * b->k[5][0][l] + -3.0689499459498917 * b->k[6][0][l] + 2.38466765651207 * b->k[7][0][l] + 2.117034582445028 * b->k[8][0][l] + -0.871391583777973 * b->k[9][0][l] + 2.2404374302607883 * b->k[10][0][l] + 0.6315787787694688 * b->k[11][0][l] + -0.08899033645133331 * b->k[12][0][l] + 18.148505520854727 * b->k[13][0][l] + -9.194632392478356 * b->k[14][0][l] + -4.436036387594894 * b->k[15][0][l]);
        b->d[4][0][l] = h * (10.427508642579134 * b->k[0][0][l] + 242.28349177525817 * b->k[5][0][l] + 165.20045171727028 * b->k[6][0][l] + -374.5467547226902 * b->k[7][0][l] + -22.113666853125306 * b->k[8][0][l] + 7.733432668472264 * b->k[9][0][l] + -30.674084731089398 * b->k[10][0][l] + -9.332130526430229 * b->k[11][0][l] + 15.697238121770845 * b->k[12][0][l] + -31.139403219565178 * b->k[13][0][l] + -9.35292435884448 * b->k[14][0][l] + 35.81684148639408 * b->k[15][0][l]);
        b->d[5][0][l] = h * (19.985053242002433 * b->k[0][0][l] + -387.0373087493518 * b->k[5][0][l] + -189.17813819516758 * b->k[6][0][l] + 527.8081592054236 * b->k[7][0][l] + -11.57390253995963 * b->k[8][0][l] + 6.8812326946963 * b->k[9][0][l] + -1.0006050966910838 * b->k[10][0][l] + 0.7777137798053443 * b->k[11][0][l] + -2.778205752353508 * b->k[12][0][l] + -60.19669523126412 * b->k[13][0][l] + 84.32040550667716 * b->k[14][0][l] + 11.99229113618279 * b->k[15][0][l]);
        b->d[6][0][l] = h * (-25.69393346270375 * b->k[0][0][l] + -154.18974869023643 * b->k[5][0][l] + -231.5293791760455 * b->k[6][0][l] + 357.6391179106141 * b->k[7][0][l] + 93.40532418362432 * b->k[8][0][l] + -37.45832313645163 * b->k[9][0][l] + 104.0996495089623 * b->k[10][0][l] + 29.8402934266605 * b->k[11][0][l] + -43.53345659001114 * b->k[12][0][l] + 96.32455395918828 * b->k[13][0][l] + -39.17726167561544 * b->k[14][0][l] + -149.72683625798564 * b->k[15][0][l]);
    }
    LANE_LOOP {
        const double h = b->h[l], move = b->xn[1][l] - b->x[1][l];
        const double slope = h * b->k[0][1][l];
        b->d[0][1][l] = move;
        b->d[1][1][l] = slope - move;
        b->d[2][1][l] = 2.0 * move - (h * b->k[12][1][l] + slope);
        b->d[3][1][l] = h * (-8.428938276109013 * b->k[0][1][l] + 0.5667149535193777 * b->k[5][1][l] + -3.0689499459498917 * b->k[6][1][l] + 2.38466765651207 * b->k[7][1][l] + 2.117034582445028 * b->k[8][1][l] + -0.871391583777973 * b->k[9][1][l] + 2.2404374302607883 * b->k[10][1][l] + 0.6315787787694688 * b->k[11][1][l] + -0.08899033645133331 * b->k[12][1][l] + 18.148505520854727 * b->k[13][1][l] + -9.194632392478356 * b->k[14][1][l] + -4.436036387594894 * b->k[15][1][l]);
        b->d[4][1][l] = h * (10.427508642579134 * b->k[0][1][l] + 242.28349177525817 * b->k[5][1][l] + 165.20045171727028 * b->k[6][1][l] + -374.5467547226902 * b->k[7][1][l] + -22.113666853125306 * b->k[8][1][l] + 7.733432668472264 * b->k[9][1][l] + -30.674084731089398 * b->k[10][1][l] + -9.332130526430229 * b->k[11][1][l] + 15.697238121770845 * b->k[12][1][l] + -31.139403219565178 * b->k[13][1][l] + -9.35292435884448 * b->k[14][1][l] + 35.81684148639408 * b->k[15][1][l]);
        b->d[5][1][l] = h * (19.985053242002433 * b->k[0][1][l] + -387.0373087493518 * b->k[5][1][l] + -189.17813819516758 * b->k[6][1][l] + 527.8081592054236 * b->k[7][1][l] + -11.57390253995963 * b->k[8][1][l] + 6.8812326946963 * b->k[9][1][l] + -1.0006050966910838 * b->k[10][1][l] + 0.7777137798053443 * b->k[11][1][l] + -2.778205752353508 * b->k[12][1][l] + -60.19669523126412 * b->k[13][1][l] + 84.32040550667716 * b->k[14][1][l] + 11.99229113618279 * b->k[15][1][l]);
        b->d[6][1][l] = h * (-25.69393346270375 * b->k[0][1][l] + -154.18974869023643 * b->k[5][1][l] + -231.5293791760455 * b->k[6][1][l] + 357.6391179106141 * b->k[7][1][l] + 93.40532418362432 * b->k[8][1][l] + -37.45832313645163 * b->k[9][1][l] + 104.0996495089623 * b->k[10][1][l] + 29.8402934266605 * b->k[11][1][l] + -43.53345659001114 * b->k[12][1][l] + 96.32455395918828 * b->k[13][1][l] + -39.17726167561544 * b->k[14][1][l] + -149.72683625798564 * b->k[15][1][l]);
    }
    LANE_LOOP {
        const double h = b->h[l], move = b->xn[2][l] - b->x[2][l];
        const double slope = h * b->k[0][2][l];
        b->d[0][2][l] = move;
        b->d[1][2][l] = slope - move;
        b->d[2][2][l] = 2.0 * move - (h * b->k[12][2][l] + slope);
        b->d[3][2][l] = h * (-8.428938276109013 * b->k[0][2][l] + 0.5667149535193777 * b->k[5][2][l] + -3.0689499459498917 * b->k[6][2][l] + 2.38466765651207 * b->k[7][2][l] + 2.117034582445028 * b->k[8][2][l] + -0.871391583777973 * b->k[9][2][l] + 2.2404374302607883 * b->k[10][2][l] + 0.6315787787694688 * b->k[11][2][l] + -0.08899033645133331 * b->k[12][2][l] + 18.148505520854727 * b->k[13][2][l] + -9.194632392478356 * b->k[14][2][l] + -4.436036387594894 * b->k[15][2][l]);
        b->d[4][2][l] = h * (10.427508642579134 * b->k[0][2][l] + 242.28349177525817 * b->k[5][2][l] + 165.20045171727028 * b->k[6][2][l] + -374.5467547226902 * b->k[7][2][l] + -22.113666853125306 * b->k[8][2][l] + 7.733432668472264 * b->k[9][2][l] + -30.674084731089398 * b->k[10][2][l] + -9.332130526430229 * b->k[11][2][l] + 15.697238121770845 * b->k[12][2][l] + -31.139403219565178 * b->k[13][2][l] + -9.35292435884448 * b->k[14][2][l] + 35.81684148639408 * b->k[15][2][l]);
        b->d[5][2][l] = h * (19.985053242002433 * b->k[0][2][l] + -387.0373087493518 * b->k[5][2][l] + -189.17813819516758 * b->k[6][2][l] + 527.8081592054236 * b->k[7][2][l] + -11.57390253995963 * b->k[8][2][l] + 6.8812326946963 * b->k[9][2][l] + -1.0006050966910838 * b->k[10][2][l] + 0.7777137798053443 * b->k[11][2][l] + -2.778205752353508 * b->k[12][2][l] + -60.19669523126412 * b->k[13][2][l] + 84.32040550667716 * b->k[14][2][l] + 11.99229113618279 * b->k[15][2][l]);
        b->d[6][2][l] = h * (-25.69393346270375 * b->k[0][2][l] + -154.18974869023643 * b->k[5][2][l] + -231.5293791760455 * b->k[6][2][l] + 357.6391179106141 * b->k[7][2][l] + 93.40532418362432 * b->k[8][2][l] + -37.45832313645163 * b->k[9][2][l] + 104.0996495089623 * b->k[10][2][l] + 29.8402934266605 * b->k[11][2][l] + -43.53345659001114 * b->k[12][2][l] + 96.32455395918828 * b->k[13][2][l] + -39.17726167561544 * b->k[14][2][l] + -149.72683625798564 * b->k[15][2][l]);
    }
    LANE_LOOP {
        const double h = b->h[l], move = b->xn[3][l] - b->x[3][l];
        const double slope = h * b->k[0][3][l];
        b->d[0][3][l] = move;
        b->d[1][3][l] = slope - move;
        b->d[2][3][l] = 2.0 * move - (h * b->k[12][3][l] + slope);
        b->d[3][3][l] = h * (-8.428938276109013 * b->k[0][3][l] + 0.5667149535193777 * b->k[5][3][l] + -3.0689499459498917 * b->k[6][3][l] + 2.38466765651207 * b->k[7][3][l] + 2.117034582445028 * b->k[8][3][l] + -0.871391583777973 * b->k[9][3][l] + 2.2404374302607883 * b->k[10][3][l] + 0.6315787787694688 * b->k[11][3][l] + -0.08899033645133331 * b->k[12][3][l] + 18.148505520854727 * b->k[13][3][l] + -9.194632392478356 * b->k[14][3][l] + -4.436036387594894 * b->k[15][3][l]);
        b->d[4][3][l] = h * (10.427508642579134 * b->k[0][3][l] + 242.28349177525817 * b->k[5][3][l] + 165.20045171727028 * b->k[6][3][l] + -374.5467547226902 * b->k[7][3][l] + -22.113666853125306 * b->k[8][3][l] + 7.733432668472264 * b->k[9][3][l] + -30.674084731089398 * b->k[10][3][l] + -9.332130526430229 * b->k[11][3][l] + 15.697238121770845 * b->k[12][3][l] + -31.139403219565178 * b->k[13][3][l] + -9.35292435884448 * b->k[14][3][l] + 35.81684148639408 * b->k[15][3][l]);
        b->d[5][3][l] = h * (19.985053242002433 * b->k[0][3][l] + -387.0373087493518 * b->k[5][3][l] + -189.17813819516758 * b->k[6][3][l] + 527.8081592054236 * b->k[7][3][l] + -11.57390253995963 * b->k[8][3][l] + 6.8812326946963 * b->k[9][3][l] + -1.0006050966910838 * b->k[10][3][l] + 0.7777137798053443 * b->k[11][3][l] + -2.778205752353508 * b->k[12][3][l] + -60.19669523126412 * b->k[13][3][l] + 84.32040550667716 * b->k[14][3][l] + 11.99229113618279 * b->k[15][3][l]);
        b->d[6][3][l] = h * (-25.69393346270375 * b->k[0][3][l] + -154.18974869023643 * b->k[5][3][l] + -231.5293791760455 * b->k[6][3][l] + 357.6391179106141 * b->k[7][3][l] + 93.40532418362432 * b->k[8][3][l] + -37.45832313645163 * b->k[9][3][l] + 104.0996495089623 * b->k[10][3][l] + 29.8402934266605 * b->k[11][3][l] + -43.53345659001114 * b->k[12][3][l] + 96.32455395918828 * b->k[13][3][l] + -39.17726167561544 * b->k[14][3][l] + -149.72683625798564 * b->k[15][3][l]);
    }
}


/* The interpolation's error: its last term, made smaller as the next one would be (h |eigenvalue|).
 * It may use up tol, while the error of the step stays below tau. */
static void measure_between(block_t *b, double tol)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double s = larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e = BETWEEN * (b->h[l] * b->rho[l] + 0.5) * fabs(b->d[6][j][l]) / s;
            b->error[l] = larger(b->error[l], e * b->tau[l] / tol);
        }
}

/* The step's error, and the velocity at its two ends, relative to each state's scale so far.  The
 * error is Hairer's combination of the two estimates of DOP853; the square of the third-order one,
 * which falls with the same power of h, guards against a fifth-order one that is zero by chance. */
static void measure(block_t *b, double tol, int between)
{
    lanes five, three;
    LANE_LOOP five[l] = three[l] = b->head[l] = b->tail[l] = 0.0;
    for (int j = 0; j < NS; ++j) {
        const double moves = j < ND ? 1.0 : 0.0;
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e5 = b->e5[j][l] * w, e3 = b->e3[j][l] * w;
            b->weight[j][l] = w;
            five[l] += e5 * e5;
            three[l] += e3 * e3;
            b->head[l] = larger(b->head[l], moves * w * fabs(b->k[0][j][l]));
            b->tail[l] = larger(b->tail[l], moves * w * fabs(b->k[STAGES - 1][j][l]));
        }
    }
    LANE_LOOP {
        const double h = b->h[l];
        const double pair = h * five[l] / sqrt(five[l] + 0.01 * three[l] + DBL_MIN);
        b->local[l] = b->error[l] = larger(pair, GUARD * h * h * three[l]);
    }
    if (between)
        measure_between(b, tol);
}

/* exp(x), within a fifth for |x| < 3 and bounded beyond. */
INLINE double swell(double x)
{
    const double z = fabs(x), p = 1.0 + z * (1.0 + z * (1.0 / 2 + z * (1.0 / 6 + z / 24)));
    return x < 0.0 ? 1.0 / p : p;
}

/* Follow the global error, which a local tolerance says nothing about: near a saddle it grows out
 * of all proportion.  Squares are summed, as local errors have no common sign.
 *
 * Along the motion: the velocity f(x(t)) of an autonomous system solves its variational equation,
 * so a local error made at s has grown by |f(t)| / |f(s)| at t, and has moved a quadrature by
 * f(t) - f(s) in the same proportion.
 * Across it: with two dynamic states the area between the velocity and an error grows by the exp of
 * the integral of the trace of J (Liouville), so an error across has grown by that over
 * |f(t)| / |f(s)|.
 *
 * At rest for good |f| fades to nothing, and rounding errors over it mean nothing either. */
static void follow_error(block_t *b, double t_end)
{
    const double rest = REST / t_end;
    LANE_LOOP {
        const double e = b->error[l] <= b->tau[l] ? b->local[l] : 0.0;
        const double head = larger(b->head[l], rest), tail = b->tail[l], per_head = 1.0 / head;
        const double trace = b->turn[ND][l], shift = e * per_head, side = e * head;
        const double grown = swell(0.5 * b->passed[l] * (b->spread[l] + trace));
        const double area = b->area[l] * grown * grown, across = ACROSS * per_head;
        const double along = e > 0.0 ? (b->drift[l] + shift * shift) * tail * tail : 0.0;
        b->doubt[l] = larger(b->doubt[l], larger(along, area * across * across));
        b->shift[l] = shift * shift;
        b->drift[l] += shift * shift;
        b->area[l] = area + side * side;
        b->passed[l] = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        b->spread[l] = trace;
    }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double s = b->shift[l], w = b->weight[j][l];
            const double first = b->k[0][j][l], last = b->k[STAGES - 1][j][l];
            const double past = b->past[j][l] + s * first;
            const double past2 = b->past2[j][l] + s * first * first;
            const double moved = last * (b->drift[l] * last - 2.0 * past) + past2;
            b->past[j][l] = past;
            b->past2[j][l] = past2;
            b->doubt[l] = larger(b->doubt[l], s > 0.0 ? moved * w * w : 0.0);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    const double grown = swell(b->passed[l] * b->spread[l]);
    const double across = ACROSS * grown / larger(b->tail[l], REST / t_end);
    return sqrt(larger(b->doubt[l], b->area[l] * across * across));
}

/* x^(-1/8), within 0.5 %: Newton from a guess by the exponent. */
INLINE double inverse_eighth_root(double x)
{
    const double y = from_bits(5182826893670980608 - (bits(x) >> 3)), y2 = y * y, y4 = y2 * y2;
    return y * (1.125 - 0.125 * x * y4 * y4);
}

/* Accept or reject lane by lane and choose the next step; says whether any lane has ended. */
static int advance(block_t *b, double t_end, double max_steps)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double x = b->error[l] <= b->tau[l] ? b->xn[j][l] : b->x[j][l];
            b->x[j][l] = x;
            b->scale[j][l] = larger(b->scale[j][l], fabs(x));
        }
    double ended = 0.0;
#pragma omp simd reduction(+ : ended)
    for (int l = 0; l < LANES; ++l) {
        const double ratio = b->error[l] / b->tau[l];
        const double wish = SAFETY * inverse_eighth_root(smaller(ratio, 1e30) + 1e-30);
        const double factor = ratio == ratio ? larger(smaller(wish, GROW), SHRINK) : SHRINK;
        const double past = b->t[l] + b->h[l] >= t_end ? t_end : b->t[l] + b->h[l];
        const double t = ratio <= 1.0 ? past : b->t[l], rest = t_end - t, h = b->h[l] * factor;
        const double steps = b->steps[l] + 1.0;
        const double stuck = ratio == ratio ? (double)STEP_LIMIT : (double)NON_FINITE;
        double state = b->state[l];
        state = steps >= max_steps ? (double)STEP_LIMIT : state;
        state = h < b->least[l] ? stuck : state;
        state = rest <= 0.0 && state < 0.0 ? (double)OK : state;
        b->t[l] = t;
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
        b->steps[l] = steps;
        b->state[l] = state;
        ended += state >= 0.0 ? 1.0 : 0.0;
    }
    return ended > 0.0;
}

/* ---- between the steps ------------------------------------------------------------------- */

INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s;
    const double end = b->d[5][j][l] + s * b->d[6][j][l];
    const double inner = b->d[3][j][l] + s * (b->d[4][j][l] + r * end);
    return b->x[j][l] + s * (b->d[0][j][l] + r * (b->d[1][j][l] + s * (b->d[2][j][l] + r * inner)));
}

/* States and outputs of one lane at the sample times within its step. */
static void sample_lane(const block_t *b, const job_t *job, int l, int64_t begin, int64_t end)
{
    double at[NS][TILE], y[NY1][TILE];
    const double per_step = 1.0 / b->h[l];
    for (int64_t from = begin; from < end; from += TILE) {
        const int count = end - from < TILE ? (int)(end - from) : TILE;
        for (int j = 0; j < NS; ++j) {
#pragma omp simd
            for (int s = 0; s < count; ++s)
                at[j][s] = dense(b, j, l, (job->times[from + s] - b->t[l]) * per_step);
        }
        if (job->observed)
            observe_row(b->c, l, at, y, count);
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + b->id[l] * job->n_times + from, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
    }
}

static void sample(block_t *b, const job_t *job)
{
    for (int l = 0; l < LANES; ++l) {
        if (b->id[l] < 0 || !(b->error[l] <= b->tau[l]))
            continue;
        const double end = b->t[l] + b->h[l] >= job->t_end ? job->t_end : b->t[l] + b->h[l];
        const int64_t begin = b->next[l];
        while (b->next[l] < job->n_times && job->times[b->next[l]] <= end)
            ++b->next[l];
        if (b->next[l] > begin)
            sample_lane(b, job, l, begin, b->next[l]);
    }
}

/* All states and outputs at the fraction theta of each lane's step. */
static void observe_at(block_t *b, const job_t *job)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
    if (job->observed)
        observe_lanes(b->c, b->at, b->y);
}

/* State or output i as `observe_at` has left it. */
INLINE const double *row(const block_t *b, int i) { return i < NS ? b->at[i] : b->y[i - NS]; }

/* Vertex of the parabola through three points at -1, 0, 1; 0 where there is none. */
INLINE double vertex(double left, double middle, double right)
{
    const double bend = left - 2.0 * middle + right, v = 0.5 * (left - right) / bend;
    return bend < 0.0 ? larger(smaller(v, 1.0), -1.0) : 0.0;
}

/* Whether a step may hold a new largest value, by what the nodes show of it. */
INLINE int rises(const lanes *node, int l, double largest)
{
    double top = 0.0;
    for (int m = 0; m <= NODES; ++m)
        top = larger(top, node[m][l]);
    return top * (1.0 + 1e-2) > largest;
}

/* Close in on the maximum of |row i| near theta: parabolas of width 1/8, 1/64, 1/512 step. */
static void refine_largest(block_t *b, const job_t *job, int i, const lanes *node)
{
    lanes centre, left, right;
    double width = 1.0 / NODES;
    LANE_LOOP {
        double best = node[1][l], place = 1.0, before = node[0][l], after = node[2][l];
        for (int m = 2; m < NODES; ++m) {
            const int up = node[m][l] > best;
            before = up ? node[m - 1][l] : before;
            after = up ? node[m + 1][l] : after;
            place = up ? (double)m : place;
            best = up ? node[m][l] : best;
        }
        centre[l] = (place + vertex(before, best, after)) * width;
    }
    for (int round = 0; round < 3; ++round) {
        width /= 8.0;
        LANE_LOOP {
            centre[l] = larger(smaller(centre[l], 1.0 - width), width);
            b->theta[l] = centre[l] - width;
        }
        observe_at(b, job);
        LANE_LOOP left[l] = fabs(row(b, i)[l]), b->theta[l] = centre[l] + width;
        observe_at(b, job);
        LANE_LOOP right[l] = fabs(row(b, i)[l]), b->theta[l] = centre[l];
        observe_at(b, job);
        LANE_LOOP centre[l] += width * vertex(left[l], fabs(row(b, i)[l]), right[l]);
    }
    LANE_LOOP b->theta[l] = centre[l];
    observe_at(b, job);
    for (int l = 0; l < LANES; ++l) {
        const double top = larger(fabs(row(b, i)[l]), larger(node[0][l], node[NODES][l]));
        if (b->error[l] <= b->tau[l] && rises(node, l, b->largest[i][l]))
            b->largest[i][l] = larger(b->largest[i][l], top);
    }
}

/* First time |row i| reaches its limit within the step: bisection between two nodes. */
static void refine_first(block_t *b, const job_t *job, int i, const lanes *node, double limit)
{
    lanes low, high;
    LANE_LOOP {
        low[l] = high[l] = NODES;
        for (int m = NODES; m >= 0; --m) {
            const int over = node[m][l] >= limit;
            high[l] = over ? m : high[l];
            low[l] = over ? (m ? m - 1.0 : 0.0) : low[l];
        }
        low[l] /= NODES;
        high[l] /= NODES;
    }
    for (int round = 0; round < 40; ++round) {
        LANE_LOOP b->theta[l] = 0.5 * (low[l] + high[l]);
        observe_at(b, job);
        LANE_LOOP {
            const int over = fabs(row(b, i)[l]) >= limit;
            high[l] = over ? b->theta[l] : high[l];
            low[l] = over ? low[l] : b->theta[l];
        }
    }
    LANE_LOOP b->theta[l] = high[l];
}

/* Running extremes of one row over the step. */
static void watch_row(block_t *b, const job_t *job, int i, const lanes *node)
{
    int higher = 0, passed = 0;
    for (int l = 0; l < LANES; ++l) {
        if (b->id[l] < 0 || !(b->error[l] <= b->tau[l]))
            continue;
        double top = 0.0;
        for (int m = 0; m <= NODES; ++m)
            top = larger(top, node[m][l]);
        higher |= rises(node, l, b->largest[i][l]);
        passed |= top >= job->limit[i] && b->first[i][l] == INFINITY;
        if (top > job->range[i])
            b->state[l] = LEFT_RANGE;
    }
    if (higher)
        refine_largest(b, job, i, node);
    if (!passed)
        return;
    refine_first(b, job, i, node, job->limit[i]);
    for (int l = 0; l < LANES; ++l) {
        int over = 0;
        for (int m = 0; m <= NODES; ++m)
            over |= node[m][l] >= job->limit[i];
        if (over && b->error[l] <= b->tau[l])
            b->first[i][l] = smaller(b->first[i][l], b->t[l] + b->theta[l] * b->h[l]);
    }
}

static void watch(block_t *b, const job_t *job)
{
    lanes node[ROWS][NODES + 1];
    for (int m = 0; m <= NODES; ++m) {
        LANE_LOOP b->theta[l] = (double)m / NODES;
        observe_at(b, job);
        for (int i = 0; i < ROWS; ++i)
            if (job->largest[i])
                LANE_LOOP node[i][m][l] = fabs(row(b, i)[l]);
    }
    for (int i = 0; i < ROWS; ++i)
        if (job->largest[i])
            watch_row(b, job, i, node[i]);
}



/* ---- loading and unloading ---------------------------------------------------------------- */

/* First steps: an explicit Euler probe measures how fast the velocity changes. */
static void first_steps(queue_t *q, double t_end, double tau)
{
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 0.125);
    rates(q->c, q->w, q->x, q->k[0]);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP q->xn[j][l] = q->x[j][l] + probe * q->k[0][j][l];
    rates(q->c, q->w, q->xn, q->k[1]);
    LANE_LOOP q->h[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double f = fabs(q->k[0][j][l]), change = fabs(q->k[1][j][l] - q->k[0][j][l]);
            q->h[l] = larger(q->h[l], change / (probe * (f + SCALE_FLOOR)));
        }
    LANE_LOOP q->h[l] = larger(smaller(ease / (q->h[l] + DBL_MIN), t_end), 1e-6 * t_end);
}

/* Take the next trajectories off the job; false if there are none. */
static int fill(queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    int64_t id;
#pragma omp atomic capture
    { id = *shared; *shared += LANES; }
    if (id >= job->n)
        return 0;
    q->id = id;
    q->used = 0;
    q->count = job->n - id < LANES ? (int)(job->n - id) : LANES;
    for (int l = 0; l < LANES; ++l) {
        const int64_t i = l < q->count ? id + l : job->n - 1;
        for (int j = 0; j < NS; ++j)
            q->x[j][l] = job->x0[j][i * job->x0_stride[j]];
    }
    for (int j = 0; j < NP; ++j)
        for (int l = 0; l < LANES && (job->p_stride[j] || !q->filled); ++l) {
            const int64_t i = l < q->count ? id + l : job->n - 1;
            q->p[j][l] = job->p[j][i * job->p_stride[j]];
        }
    q->filled = 1;
    constants(q->p, q->c);
    first_steps(q, job->t_end, tau);
    return 1;
}

/* Put lane l at the beginning of its trajectory. */
static void restart(block_t *b, int l, double tau, double h, int watched)
{
    for (int j = 0; j < NS; ++j) {
        b->x[j][l] = b->begin[j][l];
        b->scale[j][l] = larger(fabs(b->begin[j][l]), SCALE_FLOOR);
        b->weight[j][l] = 1.0 / b->scale[j][l];
        b->past[j][l] = b->past2[j][l] = 0.0;
    }
    for (int i = 0; watched && i < ROWS; ++i)
        b->largest[i][l] = 0.0, b->first[i][l] = INFINITY;
    if (b->tau[l] != tau)
        b->reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = b->drift[l] = b->area[l] = b->passed[l] = b->spread[l] = b->doubt[l] = 0.0;
    b->state[l] = RUNNING;
    b->growth[l] = b->rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->mode[j][l] = b->f0[j][l];
    b->next[l] = 0;
}

/* Load the queue's next trajectory into lane l, or leave the lane standing still for good. */
static int load(block_t *b, int l, queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    b->id[l] = -1;
    b->state[l] = RUNNING;
    b->h[l] = 0.0;
    b->t[l] = b->least[l] = -1.0;
    b->steps[l] = -INFINITY;
    if (q->used == q->count && !fill(q, job, shared, tau))
        return 0;
    const int from = q->used++;
    for (int j = 0; j < NC; ++j)
        b->c[j][l] = q->c[j][from];
    for (int j = 0; j < NS; ++j)
        b->begin[j][l] = q->x[j][from], b->f0[j][l] = q->k[0][j][from];
    b->id[l] = q->id + from;
    b->h0[l] = q->h[from];
    b->least[l] = SHORTEST * job->t_end;
    b->steps[l] = 0.0;
    b->retries[l] = 0;
    restart(b, l, tau, b->h0[l], job->largest != NULL);
    return 1;
}

static void unload(const block_t *b, int l, const job_t *job)
{
    const int64_t i = b->id[l];
    const int whole = b->state[l] == OK || b->state[l] == UNSURE;
    for (int j = 0; j < NS; ++j)
        if (job->final[j])
            job->final[j][i] = whole ? b->x[j][l] : NAN;
    for (int j = 0; job->largest && j < ROWS; ++j)
        if (job->largest[j]) {
            job->largest[j][i] = b->largest[j][l];
            job->first[j][i] = b->first[j][l];
        }
    for (int j = 0; job->samples && j < ROWS; ++j)
        for (int64_t s = b->next[l]; job->samples[j] && s < job->n_times; ++s)
            job->samples[j][i * job->n_times + s] = NAN;
    job->steps[i] = (int32_t)b->steps[l];
    job->estimate[i] = estimate(b, l, job->t_end);
    job->status[i] = (int8_t)b->state[l];
}

/* A lane has come to its end: once more with a finer tolerance if its error may be too large. */
static int retry(block_t *b, int l, const job_t *job)
{
    if (b->state[l] != OK)
        return 0;
    const double found = estimate(b, l, job->t_end), trusted = TRUST * job->tol;
    if (found <= trusted)
        return 0;
    if (b->retries[l] == RETRIES || b->tau[l] <= FINEST) {
        b->state[l] = UNSURE;
        return 0;
    }
    const double finer = larger(0.3 * b->tau[l] * trusted / found, FINEST);
    ++b->retries[l];
    restart(b, l, finer, b->h0[l] * pow(finer / b->tau[l], 0.125), job->largest != NULL);
    return 1;
}

/* ---- the job ------------------------------------------------------------------------------ */

static void work(const job_t *job, int64_t *shared)
{
    block_t b;
    queue_t q = {.used = 0, .count = 0};
    memset(&b, 0, sizeof b);
    const int between = job->samples || job->largest;
    const double tau = larger(SHARE * job->tol, FINEST);
    int running = 0;
    for (int l = 0; l < LANES; ++l)
        running += load(&b, l, &q, job, shared, tau);
    while (running) {
        attempt(&b);
        if (between)
            prepare_dense(&b);
        measure(&b, job->tol, between);
        if (between) {
            if (job->samples)
                sample(&b, job);
            if (job->largest)
                watch(&b, job);
        }
        follow_error(&b, job->t_end);
        if (!advance(&b, job->t_end, (double)job->max_steps))
            continue;
        for (int l = 0; l < LANES; ++l) {
            if (b.state[l] == RUNNING || b.id[l] < 0 || retry(&b, l, job))
                continue;
            unload(&b, l, job);
            running -= !load(&b, l, &q, job, shared, tau);
        }
    }
}

/* Integrate all trajectories of the job. */
__attribute__((visibility("default"))) void integrate(const job_t *job)
{
    int64_t shared = 0;
    if (job->threads <= 1) {
        work(job, &shared);
        return;
    }
#pragma omp parallel num_threads((int)job->threads)
    work(job, &shared);
}

