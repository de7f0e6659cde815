/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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


#if DRIVER == 2
enum { LANES = 16 };                    /* moments of a step */
#else
enum { LANES = 32 };                    /* trajectories */
#endif
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* ---- elementary functions, branch-free so that loops over lanes become vector code ---------
 * Errors of few units of the last place, as tests/test_elementary.py says.  NaN in, NaN out. */

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

/* 2^n for whole numbers from -1022 to 1023, as they stand in the last bits of n + magic. */
INLINE double two_to(int64_t n) { return from_bits((int64_t)((uint64_t)(n + 1023) << 52)); }

/* r and n of x = n log 2 + r, |r| <= log(2) / 2; the whole number is handed on as an integer. */
INLINE double halve(double x, int64_t *n)
{
    const double magic = 6755399441055744.0, rounded = x * 1.4426950408889634 + magic;
    const double whole = rounded - magic;
    *n = bits(rounded) - bits(magic);
    return (x - whole * 0.6931471804855391) - whole * 7.440617110012397e-11;
}

/* exp(s) - 1 for |s| <= log(2) / 2 */
INLINE double small_expm1(double s)
{
    const double s2 = s * s, p = (0.5000000000000011 + s2 * (0.04166666666652901 + s2 * (0.0013888888943991541 + s2 * (2.4801492673882887e-05 + s2 * 2.763041554362714e-07)))) + s * (0.16666666666666402 + s2 * (0.00833333333350108 + s2 * (0.0001984126949183641 + s2 * (2.7557599835008617e-06 + s2 * 2.4995723761300685e-08))));
    return s + s2 * p;
}

/* exp: beyond what a number can hold infinity or 0, in two factors that both can be held. */
INLINE double lane_exp(double x)
{
    const double most = x > 710.0 ? 710.0 : x, y = most < -746.0 ? -746.0 : most;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), one = two_to(n >> 1), two = two_to(n - (n >> 1));
    return (one + one * e) * two;
}

/* exp(x) - 1, exact where x is small; up to 700. */
INLINE double bounded_expm1(double x)
{
    const double y = x < -40.0 ? -40.0 : x;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), power = two_to(n);
    return power * e + (power - 1.0);
}

INLINE double lane_expm1(double x)
{
    const double large = lane_exp(x), small = bounded_expm1(x > 40.0 ? 40.0 : x);
    return x > 40.0 ? large : small;
}

/* log(2^n (1 + f)) + more, 1 + f between the roots of 1/2 and 2. */
INLINE double sum_log(double n, double f, double more)
{
    const double t = f / (2.0 + f), s = t * t, s2 = s * s, half = 0.5 * f * f;
    const double p = (0.6666666666666735 + s2 * (0.28571428743261834 + s2 * (0.18183569731612698 + s2 * 0.14797505200529643))) + s * (0.39999999999411096 + s2 * (0.22222198476116337 + s2 * 0.15313903480505622));
    return n * 0.6931471804855391 - ((half - (t * (half + s * p) + (n * 7.440617110012397e-11 + more))) - f);
}

/* n and f of x = 2^n (1 + f), x > 0 and normal. */
INLINE double take_apart(double x, double *n)
{
    const int64_t root = 0x3fe6a09e667f3bcd, apart = bits(x) - root, power = apart >> 52;
    *n = from_bits(power + 0x4338000000000000) - 6755399441055744.0;
    return from_bits((apart & 0xfffffffffffff) + root) - 1.0;
}

INLINE double lane_log(double x)
{
    const int tiny = x < DBL_MIN;
    double n;
    const double f = take_apart(tiny ? x * 0x1p54 : x, &n);
    const double finite = sum_log(tiny ? n - 54.0 : n, f, 0.0);
    const double sound = x < INFINITY ? finite : x, lost = x < 0.0 ? NAN : sound;
    return x == 0.0 ? -INFINITY : lost;
}

/* log(1 + x): what is lost in 1 + x is added again. */
INLINE double lane_log1p(double x)
{
    const double u = 1.0 + x, rest = u > 0x1p53 ? 0.0 : (x - (u - 1.0)) / u;
    double n;
    const double finite = sum_log(n, take_apart(u, &n), rest);
    const double sound = x < INFINITY ? finite : x, lost = x < -1.0 ? NAN : sound;
    return x == -1.0 ? -INFINITY : lost;
}

/* x^y; a negative x has whole powers only.  Its error is |y log x| units of the last place. */
INLINE double lane_pow(double x, double y)
{
    const double size = lane_exp(y * lane_log(fabs(x))), half = 0.5 * y;
    const double odd = half == floor(half) ? 1.0 : -1.0, whole = y == floor(y) ? odd : NAN;
    const double signed_size = x < 0.0 ? whole * size : size;
    return y == 0.0 || x == 1.0 ? 1.0 : signed_size;
}

INLINE double lane_tanh(double x)
{
    const double size = fabs(x), e = bounded_expm1(2.0 * (size > 20.0 ? 20.0 : size));
    return copysign(e / (e + 2.0), x);
}

INLINE double lane_sinh(double x)
{
    const double size = fabs(x), e = bounded_expm1(size > 40.0 ? 40.0 : size);
    const double half = lane_exp(0.5 * size);
    return copysign(size > 40.0 ? 0.5 * half * half : 0.5 * (e + e / (e + 1.0)), x);
}

INLINE double lane_cosh(double x)
{
    const double size = fabs(x), half = lane_exp(0.5 * size), e = lane_exp(size > 40.0 ? 40.0 : size);
    return size > 40.0 ? 0.5 * half * half : 0.5 * (e + 1.0 / e);
}

INLINE double lane_asinh(double x)
{
    const double size = fabs(x), most = size > 1e9 ? 1e9 : size, square = most * most;
    const double near = lane_log1p(most + square / (1.0 + sqrt(1.0 + square)));
    const double far = lane_log(size) + 0.6931471805599453;
    return copysign(size > 1e9 ? far : near, x);
}

INLINE double lane_acosh(double x)
{
    const double t = x - 1.0, most = t > 1e9 ? 1e9 : t;
    const double near = lane_log1p(most + sqrt(most * (most + 2.0)));
    const double far = lane_log(x) + 0.6931471805599453;
    return t > 1e9 ? far : near;
}

INLINE double lane_atanh(double x)
{
    const double size = fabs(x);
    return copysign(0.5 * lane_log1p(2.0 * size / (1.0 - size)), x);
}

INLINE double lane_asin(double x) { return lane_atan(x / sqrt((1.0 - x) * (1.0 + x))); }
INLINE double lane_acos(double x) { return 2.0 * lane_atan(sqrt((1.0 - x) / (1.0 + x))); }

/* Angle of (x, y), with the signs of zero as in C. */
INLINE double lane_atan2(double y, double x)
{
    const double a = fabs(x), b = fabs(y), more = a > b ? a : b, less = a > b ? b : a;
    const double ratio = less == more ? (more == 0.0 ? 0.0 : 1.0) : less / more;
    const double angle = lane_atan(ratio), first = b > a ? 1.5707963267948966 - angle : angle;
    const double turned = bits(x) < 0 ? 3.141592653589793 - first : first;
    return copysign(a + b == a + b ? turned : a + b, y);
}

INLINE double lane_hypot(double x, double y) { return sqrt(x * x + y * y); }

/* Minimum and maximum that let NaN through, unlike fmin and fmax. */
INLINE double lane_min(double a, double b) { return a < b ? a : (b <= a ? b : a + b); }
INLINE double lane_max(double a, double b) { return a > b ? a : (b >= a ? b : a + b); }

INLINE double lane_sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }


INLINE double larger(double a, double b) { return a > b ? a : b; }
INLINE double smaller(double a, double b) { return a < b ? a : b; }

/* ---- the job ------------------------------------------------------------------------------ */

#if CARRY == 0
enum { NS = 4, ND = 2, S0 = 0, S1 = 1, S2 = 2, S3 = 3, S4 = -1, S5 = -1, S6 = -1 };
#elif CARRY == 1
enum { NS = 5, ND = 2, S0 = 0, S1 = 1, S2 = 2, S3 = 3, S4 = -1, S5 = -1, S6 = 4 };
#elif CARRY == 2
enum { NS = 7, ND = 3, S0 = 0, S1 = 1, S2 = 3, S3 = 4, S4 = 5, S5 = 6, S6 = 2 };
#endif
enum { NU = 1, NP = 20, NY = 11, NU1 = 1, NY1 = 11, ND1 = ND ? ND : 1 };
enum { NC = VARYING ? 41 : 44 };
#define PLANE 1
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

#if VARYING
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
        const double w31 = p[4][l] * w23;
        const double w32 = p[3][l] * w15;
        const double w33 = -w32;
        const double w34 = p[4][l] * p[9][l];
        const double w35 = w31 + w34;
        const double w36 = 1.0 / p[2][l];
        const double w37 = w36 * w35;
        const double w38 = w36 * w19;
        const double w39 = w36 * w33;
        const double w40 = w1 * w20;
        const double w41 = 1.0 / w3;
        const double w42 = w41 * w40;
        const double w43 = w8 * w42;
        const double w44 = p[15][l] * w42;
        const double w45 = -p[1][l];
        const double w46 = p[19][l] * p[1][l];
        const double w47 = w10 * w10;
        const double w48 = p[18][l] * w10;
        const double w49 = w11 * w48;
        const double w50 = p[15][l] * p[15][l];
        const double w51 = p[16][l] * p[15][l];
        const double w52 = p[17][l] * w51;
        const double w53 = p[10][l] * w52;
        const double w54 = w3 * w53;
        const double w55 = 2.0 * w54;
        const double w56 = w20 * w20;
        const double w57 = w18 * w20;
        const double w58 = p[6][l] * w57;
        const double w59 = w22 * w58;
        const double w60 = p[9][l] * w20;
        const double w61 = w59 + w60;
        const double w62 = w27 * w55;
        const double w63 = w27 * w61;
        const double w64 = -w62;
        const double w65 = -w63;
        const double w66 = p[4][l] * w59;
        const double w67 = p[3][l] * w55;
        const double w68 = -w67;
        const double w69 = p[4][l] * w60;
        const double w70 = w66 + w69;
        const double w71 = w36 * w70;
        const double w72 = w36 * w68;
        const double w73 = w1 / w4;
        const double w74 = w8 * w73;
        const double w75 = p[15][l] * w73;
        const double w76 = p[18][l] * w75;
        const double w77 = w11 * w76;
        const double w78 = p[4][l] / p[5][l];
        const double w79 = w18 * w78;
        const double w80 = p[6][l] * w79;
        const double w81 = w22 * w80;
        const double w82 = p[4][l] * w81;
        const double w83 = w1 * p[3][l];
        const double w84 = w83 / w4;
        const double w85 = w8 * w84;
        const double w86 = p[15][l] * w84;
        const double w87 = p[18][l] * w86;
        const double w88 = w11 * w87;
        const double w89 = p[9][l] * w78;
        const double w90 = p[4][l] * w89;
        const double w91 = w82 + w90;
        const double w92 = w36 * w91;
        const double w93 = w63 + w92;
        const double w94 = w36 * w67;
        const double w95 = -w93;
        const double w96 = -w94;
        c[0][l] = p[3][l];
        c[1][l] = p[5][l];
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
        c[18][l] = w33;
        c[19][l] = w35;
        c[20][l] = w37;
        c[21][l] = w38;
        c[22][l] = w39;
        c[23][l] = w43;
        c[24][l] = w44;
        c[25][l] = w45;
        c[26][l] = w46;
        c[27][l] = w47;
        c[28][l] = w49;
        c[29][l] = w50;
        c[30][l] = w56;
        c[31][l] = w64;
        c[32][l] = w65;
        c[33][l] = w71;
        c[34][l] = w72;
        c[35][l] = w74;
        c[36][l] = w77;
        c[37][l] = w85;
        c[38][l] = w88;
        c[39][l] = w95;
        c[40][l] = w96;
    }
}

INLINE void rate0(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x6 = MOVE(x, S6);
    const double u0 = u[0][l];
    const double w0 = c[0][l] * x1;
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
    const double w13 = c[14][l] * u0;
    const double w14 = w12 + w13;
    const double w15 = c[17][l] * w11;
    const double w16 = w14 + w15;
    const double w17 = c[21][l] * u0;
    const double w18 = c[20][l] * w11;
    const double w19 = w17 + w18;
    const double w20 = lane_cos(x6);
    const double w21 = lane_sin(x6);
    const double w22 = x0 * w21;
    const double w23 = c[1][l] * w20;
    const double w24 = -w22;
    const double w25 = w23 + w24;
    const double w26 = x0 * w20;
    const double w27 = c[1][l] * w21;
    const double w28 = w27 + w26;
    w[0][l] = w7;
    w[2][l] = w16;
    w[3][l] = w19;
    WRITE(f, S2, x0);
    WRITE(f, S3, x1);
    WRITE(f, S4, w25);
    WRITE(f, S5, w28);
    WRITE(f, S6, x1);
}

INLINE void rate1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[4][l] * w0;
    w[1][l] = w1;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[16][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[22][l] * w0;
    const double w4 = w[3][l] + w3;
    WRITE(f, S0, w2);
    WRITE(f, S1, w4);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[4];
    LANE_LOOP rate0(c, u, x, f, w, l);
    LANE_LOOP rate1(c, u, x, f, w, l);
    LANE_LOOP rate2(c, u, x, f, w, l);
}

#if DRIVER == 1
INLINE void turn0(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x6 = MOVE(x, S6);
    const double e0 = MOVE(e, S0);
    const double e1 = MOVE(e, S1);
    const double e6 = MOVE(e, S6);
    const double m0 = MOVE(m, S0);
    const double m1 = MOVE(m, S1);
    const double m6 = MOVE(m, S6);
    const double u0 = u[0][l];
    const double w0 = c[0][l] * x1;
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
    const double w13 = c[14][l] * u0;
    const double w14 = w12 + w13;
    const double w15 = c[17][l] * w11;
    const double w16 = w14 + w15;
    const double w17 = c[21][l] * u0;
    const double w18 = c[20][l] * w11;
    const double w19 = w17 + w18;
    const double w20 = lane_cos(x6);
    const double w21 = lane_sin(x6);
    const double w22 = x0 * w21;
    const double w23 = c[1][l] * w20;
    const double w24 = -w22;
    const double w25 = w23 + w24;
    const double w26 = x0 * w20;
    const double w27 = c[1][l] * w21;
    const double w28 = w27 + w26;
    const double w29 = c[0][l] * e1;
    const double w30 = e0 + w29;
    const double w31 = w1 * w1;
    const double w32 = c[27][l] * w31;
    const double w33 = w32 + 1.0;
    const double w34 = 1.0 / w33;
    const double w35 = w30 * w34;
    const double w36 = w6 * w6;
    const double w37 = c[29][l] * w36;
    const double w38 = w37 + 1.0;
    const double w39 = 1.0 / w38;
    const double w40 = c[5][l] * w30;
    const double w41 = c[28][l] * w35;
    const double w42 = w40 + w41;
    const double w43 = w42 * w39;
    const double w44 = w9 * w9;
    const double w45 = c[30][l] * w44;
    const double w46 = w45 + 1.0;
    const double w47 = 1.0 / w46;
    const double w48 = c[10][l] * e1;
    const double w49 = e0 + w48;
    const double w50 = w49 * w47;
    const double w51 = c[15][l] * e1;
    const double w52 = c[32][l] * w50;
    const double w53 = w51 + w52;
    const double w54 = c[33][l] * w50;
    const double w55 = w21 * e6;
    const double w56 = w21 * e0;
    const double w57 = w20 * e6;
    const double w58 = x0 * w57;
    const double w59 = c[15][l] * w55;
    const double w60 = -w56;
    const double w61 = w59 + w60;
    const double w62 = -w58;
    const double w63 = w61 + w62;
    const double w64 = w20 * e0;
    const double w65 = x0 * w55;
    const double w66 = c[1][l] * w57;
    const double w67 = w66 + w64;
    const double w68 = -w65;
    const double w69 = w67 + w68;
    const double w70 = c[0][l] * m1;
    const double w71 = m0 + w70;
    const double w72 = w71 * w34;
    const double w73 = c[5][l] * w71;
    const double w74 = c[28][l] * w72;
    const double w75 = w73 + w74;
    const double w76 = w75 * w39;
    const double w77 = c[10][l] * m1;
    const double w78 = m0 + w77;
    const double w79 = w78 * w47;
    const double w80 = c[15][l] * m1;
    const double w81 = c[32][l] * w79;
    const double w82 = w80 + w81;
    const double w83 = c[33][l] * w79;
    const double w84 = w21 * m6;
    const double w85 = w21 * m0;
    const double w86 = w20 * m6;
    const double w87 = x0 * w86;
    const double w88 = c[15][l] * w84;
    const double w89 = -w85;
    const double w90 = w88 + w89;
    const double w91 = -w87;
    const double w92 = w90 + w91;
    const double w93 = w20 * m0;
    const double w94 = x0 * w84;
    const double w95 = c[1][l] * w86;
    const double w96 = w95 + w93;
    const double w97 = -w94;
    const double w98 = w96 + w97;
    w[0][l] = w7;
    w[2][l] = w16;
    w[3][l] = w19;
    w[4][l] = w43;
    w[5][l] = w53;
    w[6][l] = w54;
    w[7][l] = w76;
    w[8][l] = w82;
    w[9][l] = w83;
    WRITE(f, S2, x0);
    WRITE(f, S3, x1);
    WRITE(f, S4, w25);
    WRITE(f, S5, w28);
    WRITE(f, S6, x1);
    WRITE(r, S2, e0);
    WRITE(r, S3, e1);
    WRITE(r, S4, w63);
    WRITE(r, S5, w69);
    WRITE(r, S6, e1);
    WRITE_MOVING(g, S2, m0);
    WRITE_MOVING(g, S3, m1);
    WRITE_MOVING(g, S4, w92);
    WRITE_MOVING(g, S5, w98);
    WRITE_MOVING(g, S6, m1);
}

INLINE void turn1(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[4][l] * w0;
    w[1][l] = w1;
}

INLINE void turn2(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[16][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[22][l] * w0;
    const double w4 = w[3][l] + w3;
    const double w5 = lane_cos(w[1][l]);
    const double w6 = w5 * w[4][l];
    const double w7 = c[31][l] * w6;
    const double w8 = w[5][l] + w7;
    const double w9 = c[34][l] * w6;
    const double w10 = w[6][l] + w9;
    const double w11 = w5 * w[7][l];
    const double w12 = c[31][l] * w11;
    const double w13 = w[8][l] + w12;
    const double w14 = c[34][l] * w11;
    const double w15 = w[9][l] + w14;
    WRITE(f, S0, w2);
    WRITE(f, S1, w4);
    WRITE(r, S0, w8);
    WRITE(r, S1, w10);
    WRITE_MOVING(g, S0, w13);
    WRITE_MOVING(g, S1, w15);
}

APART void turns(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g)
{
    lanes w[10];
    LANE_LOOP turn0(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn1(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn2(c, u, x, e, m, f, r, g, w, l);
}
#endif

INLINE void output(const lanes *c, int l, double x0, double x1, double u0, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10)
{
    const double w0 = c[0][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[10][l] * x1;
    const double w3 = x0 + w2;
    const double w4 = c[11][l] * w3;
    const double w5 = lane_atan(w4);
    const double w6 = c[11][l] * w1;
    const double w7 = lane_atan(w6);
    const double w8 = c[11][l] * x0;
    const double w9 = lane_atan(w8);
    const double w10 = c[24][l] * w1;
    const double w11 = lane_atan(w10);
    const double w12 = c[23][l] * w1;
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
    const double w23 = u0 + w22;
    const double w24 = c[9][l] * w18;
    const double w25 = w23 + w24;
    const double w26 = c[14][l] * w25;
    const double w27 = c[10][l] * u0;
    const double w28 = c[19][l] * w5;
    const double w29 = w27 + w28;
    const double w30 = c[18][l] * w18;
    const double w31 = w29 + w30;
    const double w32 = x1 * x0;
    const double w33 = c[25][l] * w32;
    *y0 = w7;
    *y1 = w5;
    *y2 = w9;
    *y3 = w19;
    *y4 = w20;
    *y5 = w21;
    *y6 = w26;
    *y7 = w25;
    *y8 = w31;
    *y9 = w33;
    *y10 = c[26][l];
}

APART void observe_lanes(const lanes *c, const lanes *u, const lanes *x, lanes *y)
{
    LANE_LOOP {
        output(c, l, PICK(x, S0, l), PICK(x, S1, l), u[0][l], &y[0][l], &y[1][l], &y[2][l], &y[3][l], &y[4][l], &y[5][l], &y[6][l], &y[7][l], &y[8][l], &y[9][l], &y[10][l]);
    }
}

APART void observe_row(const lanes *c, int l, double (*u)[TILE], double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, PICK(x, S0, s), PICK(x, S1, s), u[0][s], &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s]);
}

#else
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
        c[2][l] = p[5][l];
        c[3][l] = p[9][l];
        c[4][l] = p[15][l];
        c[5][l] = p[16][l];
        c[6][l] = w9;
        c[7][l] = w10;
        c[8][l] = w12;
        c[9][l] = w15;
        c[10][l] = w16;
        c[11][l] = w19;
        c[12][l] = w20;
        c[13][l] = w23;
        c[14][l] = w26;
        c[15][l] = w27;
        c[16][l] = w28;
        c[17][l] = w29;
        c[18][l] = w30;
        c[19][l] = w31;
        c[20][l] = w35;
        c[21][l] = w36;
        c[22][l] = w38;
        c[23][l] = w40;
        c[24][l] = w41;
        c[25][l] = w42;
        c[26][l] = w46;
        c[27][l] = w47;
        c[28][l] = w48;
        c[29][l] = w49;
        c[30][l] = w50;
        c[31][l] = w52;
        c[32][l] = w53;
        c[33][l] = w59;
        c[34][l] = w67;
        c[35][l] = w68;
        c[36][l] = w74;
        c[37][l] = w75;
        c[38][l] = w77;
        c[39][l] = w80;
        c[40][l] = w88;
        c[41][l] = w91;
        c[42][l] = w98;
        c[43][l] = w99;
    }
}

INLINE void rate0(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x6 = MOVE(x, S6);
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[7][l] * w1;
    const double w3 = lane_atan(w2);
    const double w4 = c[6][l] * w1;
    const double w5 = c[8][l] * w3;
    const double w6 = w4 + w5;
    const double w7 = c[4][l] * w6;
    const double w8 = c[11][l] * x1;
    const double w9 = x0 + w8;
    const double w10 = c[12][l] * w9;
    const double w11 = lane_atan(w10);
    const double w12 = c[16][l] * x1;
    const double w13 = w12 + c[19][l];
    const double w14 = c[18][l] * w11;
    const double w15 = w13 + w14;
    const double w16 = c[23][l] * w11;
    const double w17 = w16 + c[25][l];
    const double w18 = lane_cos(x6);
    const double w19 = lane_sin(x6);
    const double w20 = x0 * w19;
    const double w21 = c[2][l] * w18;
    const double w22 = -w20;
    const double w23 = w21 + w22;
    const double w24 = x0 * w18;
    const double w25 = c[2][l] * w19;
    const double w26 = w25 + w24;
    w[0][l] = w7;
    w[2][l] = w15;
    w[3][l] = w17;
    WRITE(f, S2, x0);
    WRITE(f, S3, x1);
    WRITE(f, S4, w23);
    WRITE(f, S5, w26);
    WRITE(f, S6, x1);
}

INLINE void rate1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[5][l] * w0;
    w[1][l] = w1;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[17][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[24][l] * w0;
    const double w4 = w[3][l] + w3;
    WRITE(f, S0, w2);
    WRITE(f, S1, w4);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[4];
    LANE_LOOP rate0(c, u, x, f, w, l);
    LANE_LOOP rate1(c, u, x, f, w, l);
    LANE_LOOP rate2(c, u, x, f, w, l);
}

#if DRIVER == 1
INLINE void turn0(const lanes *c, const lanes *x, const lanes *m, lanes *f, lanes *g, double *trace, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x6 = MOVE(x, S6);
    const double m0 = MOVE(m, S0);
    const double m1 = MOVE(m, S1);
    const double m6 = MOVE(m, S6);
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[7][l] * w1;
    const double w3 = lane_atan(w2);
    const double w4 = c[6][l] * w1;
    const double w5 = c[8][l] * w3;
    const double w6 = w4 + w5;
    const double w7 = c[4][l] * w6;
    const double w8 = c[11][l] * x1;
    const double w9 = x0 + w8;
    const double w10 = c[12][l] * w9;
    const double w11 = lane_atan(w10);
    const double w12 = c[16][l] * x1;
    const double w13 = w12 + c[19][l];
    const double w14 = c[18][l] * w11;
    const double w15 = w13 + w14;
    const double w16 = c[23][l] * w11;
    const double w17 = w16 + c[25][l];
    const double w18 = lane_cos(x6);
    const double w19 = lane_sin(x6);
    const double w20 = x0 * w19;
    const double w21 = c[2][l] * w18;
    const double w22 = -w20;
    const double w23 = w21 + w22;
    const double w24 = x0 * w18;
    const double w25 = c[2][l] * w19;
    const double w26 = w25 + w24;
    const double w27 = w1 * w1;
    const double w28 = c[30][l] * w27;
    const double w29 = w28 + 1.0;
    const double w30 = 1.0 / w29;
    const double w31 = w6 * w6;
    const double w32 = c[32][l] * w31;
    const double w33 = w32 + 1.0;
    const double w34 = 1.0 / w33;
    const double w35 = w9 * w9;
    const double w36 = c[33][l] * w35;
    const double w37 = w36 + 1.0;
    const double w38 = 1.0 / w37;
    const double w39 = c[1][l] * m1;
    const double w40 = m0 + w39;
    const double w41 = w40 * w30;
    const double w42 = c[6][l] * w40;
    const double w43 = c[31][l] * w41;
    const double w44 = w42 + w43;
    const double w45 = w44 * w34;
    const double w46 = c[11][l] * m1;
    const double w47 = m0 + w46;
    const double w48 = w47 * w38;
    const double w49 = c[16][l] * m1;
    const double w50 = c[35][l] * w48;
    const double w51 = w49 + w50;
    const double w52 = c[36][l] * w48;
    const double w53 = w19 * m6;
    const double w54 = w19 * m0;
    const double w55 = w18 * m6;
    const double w56 = x0 * w55;
    const double w57 = c[16][l] * w53;
    const double w58 = -w54;
    const double w59 = w57 + w58;
    const double w60 = -w56;
    const double w61 = w59 + w60;
    const double w62 = w18 * m0;
    const double w63 = x0 * w53;
    const double w64 = c[2][l] * w55;
    const double w65 = w64 + w62;
    const double w66 = -w63;
    const double w67 = w65 + w66;
    const double w68 = c[39][l] * w30;
    const double w69 = w68 + c[38][l];
    const double w70 = w69 * w34;
    const double w71 = c[41][l] * w30;
    const double w72 = w71 + c[40][l];
    const double w73 = w72 * w34;
    const double w74 = c[42][l] * w38;
    w[0][l] = w7;
    w[2][l] = w15;
    w[3][l] = w17;
    w[4][l] = w45;
    w[5][l] = w51;
    w[6][l] = w52;
    w[7][l] = w70;
    w[8][l] = w73;
    w[9][l] = w74;
    WRITE(f, S2, x0);
    WRITE(f, S3, x1);
    WRITE(f, S4, w23);
    WRITE(f, S5, w26);
    WRITE(f, S6, x1);
    WRITE_MOVING(g, S2, m0);
    WRITE_MOVING(g, S3, m1);
    WRITE_MOVING(g, S4, w61);
    WRITE_MOVING(g, S5, w67);
    WRITE_MOVING(g, S6, m1);
}

INLINE void turn1(const lanes *c, const lanes *x, const lanes *m, lanes *f, lanes *g, double *trace, lanes *w, int l)
{
    const double w0 = lane_atan(w[0][l]);
    const double w1 = c[5][l] * w0;
    w[1][l] = w1;
}

INLINE void turn2(const lanes *c, const lanes *x, const lanes *m, lanes *f, lanes *g, double *trace, lanes *w, int l)
{
    const double w0 = lane_sin(w[1][l]);
    const double w1 = c[17][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[24][l] * w0;
    const double w4 = w[3][l] + w3;
    const double w5 = lane_cos(w[1][l]);
    const double w6 = w5 * w[4][l];
    const double w7 = c[34][l] * w6;
    const double w8 = w[5][l] + w7;
    const double w9 = c[37][l] * w6;
    const double w10 = w[6][l] + w9;
    const double w11 = w5 * w[7][l];
    const double w12 = w5 * w[8][l];
    const double w13 = c[34][l] * w11;
    const double w14 = w[9][l] + w13;
    const double w15 = c[43][l] * w12;
    const double w16 = w14 + w15;
    WRITE(f, S0, w2);
    WRITE(f, S1, w4);
    WRITE_MOVING(g, S0, w8);
    WRITE_MOVING(g, S1, w10);
    trace[l] = w16;
}

APART void turns(const lanes *c, const lanes *x, const lanes *m, lanes *f, lanes *g, double *trace)
{
    lanes w[10];
    LANE_LOOP turn0(c, x, m, f, g, trace, w, l);
    LANE_LOOP turn1(c, x, m, f, g, trace, w, l);
    LANE_LOOP turn2(c, x, m, f, g, trace, w, l);
}
#endif

INLINE void output(const lanes *c, int l, double x0, double x1, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10)
{
    const double w0 = c[1][l] * x1;
    const double w1 = x0 + w0;
    const double w2 = c[11][l] * x1;
    const double w3 = x0 + w2;
    const double w4 = c[12][l] * w3;
    const double w5 = lane_atan(w4);
    const double w6 = c[12][l] * w1;
    const double w7 = lane_atan(w6);
    const double w8 = c[12][l] * x0;
    const double w9 = lane_atan(w8);
    const double w10 = c[27][l] * w1;
    const double w11 = lane_atan(w10);
    const double w12 = c[26][l] * w1;
    const double w13 = c[8][l] * w11;
    const double w14 = w12 + w13;
    const double w15 = c[4][l] * w14;
    const double w16 = lane_atan(w15);
    const double w17 = c[5][l] * w16;
    const double w18 = lane_sin(w17);
    const double w19 = c[9][l] * w18;
    const double w20 = c[13][l] * w5;
    const double w21 = c[3][l] * w5;
    const double w22 = c[14][l] * w5;
    const double w23 = w22 + c[0][l];
    const double w24 = c[10][l] * w18;
    const double w25 = w23 + w24;
    const double w26 = c[15][l] * w25;
    const double w27 = c[22][l] * w5;
    const double w28 = w27 + c[21][l];
    const double w29 = c[20][l] * w18;
    const double w30 = w28 + w29;
    const double w31 = x1 * x0;
    const double w32 = c[28][l] * w31;
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
    *y10 = c[29][l];
}

APART void observe_lanes(const lanes *c, const lanes *u, const lanes *x, lanes *y)
{
    LANE_LOOP {
        output(c, l, PICK(x, S0, l), PICK(x, S1, l), &y[0][l], &y[1][l], &y[2][l], &y[3][l], &y[4][l], &y[5][l], &y[6][l], &y[7][l], &y[8][l], &y[9][l], &y[10][l]);
    }
}

APART void observe_row(const lanes *c, int l, double (*u)[TILE], double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, PICK(x, S0, s), PICK(x, S1, s), &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s]);
}

#endif

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
/* Many trajectories side by side, every lane with its own time, step and tolerance.
 *
 * A block holds LANES trajectories as structure of arrays; every loop over lanes is a vector
 * loop.  A lane that has reached the end is written out and loaded with the next trajectory, so
 * no lane waits for a slower neighbour.  A lane never reads another lane: a result does not
 * depend on the number of threads, on the order, or on the company a trajectory keeps.
 *
 * Never build with -ffast-math: it hides NaN and shares rounding errors between lanes.
 */
enum { NODES = 8 };

static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 6.0;

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


typedef struct {
    lanes c[NC], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS];
    lanes k[KEPT_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1];
    lanes largest[WATCHES], first[WATCHES], size[WATCHES];
    lanes t, h, h0, least, tau, error, steps, state, theta, stop, finish;
    method_t method;
    errors_t errors;
#if VARYING
    inputs_t in;
    lanes u[NU1], when, wish;
    int terms;
#endif
    int64_t id[LANES], next[LANES];
    int retries[LANES], cause[LANES];
} __attribute__((aligned(64))) block_t;

/* Trajectories ready to be loaded into lanes. */
typedef struct {
    lanes p[NP], c[NC], x[NS], xn[NS], k[2][NS], h;
#if VARYING
    inputs_t in;
    lanes u[NU1], when;
#endif
    int64_t id;
    int used, count, filled;               /* filled: numbers that all share are there */
} __attribute__((aligned(64))) queue_t;

#if VARYING
#define INPUTS(b) ((b)->u)
#else
#define INPUTS(b) NULL
#endif

/* Inputs at a fraction of each lane's step. */
INLINE void set_inputs(block_t *b, const double *fraction)
{
#if VARYING
    LANE_LOOP b->when[l] = b->t[l] + fraction[l] * b->h[l];
    inputs_at(&b->in, b->terms, b->when, b->u);
#endif
}

/* Inputs at a fraction that is the same for all. */
INLINE void set_inputs_at(block_t *b, double fraction)
{
#if VARYING
    LANE_LOOP b->when[l] = b->t[l] + fraction * b->h[l];
    inputs_at(&b->in, b->terms, b->when, b->u);
#endif
}

/* ---- a step of DOP853 --------------------------------------------------------------------- */

/* Keep the step within REACH tau^(1/12) / |largest eigenvalue|.  Near the edge of stability the
 * fast modes that have died out make the error estimate blind, now and then by a factor of a
 * hundred.  The eigenvalue comes from a power iteration that makes one turn a step:
 * turn = J mode. */
static void cap(block_t *b, lanes *turn)
{
    lanes size, grown;
    LANE_LOOP size[l] = grown[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l];
            size[l] = larger(size[l], w * fabs(b->method.mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(turn[j][l]));
        }
    LANE_LOOP {
        const double growth = grown[l] / (size[l] + DBL_MIN);
        const double mean = sqrt(growth * b->method.growth[l]);
        const double rho = larger(mean, HOLD * b->method.rho[l]), h = b->h[l];
        b->method.growth[l] = growth;
        b->method.rho[l] = rho;
        b->h[l] = h * rho > b->method.reach[l] ? b->method.reach[l] / rho : h;
        size[l] = growth > 0.0 ? 1.0 / grown[l] : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->method.mode[j][l] = size[l] > 0.0 ? turn[j][l] * size[l] : b->method.mode[j][l];
}

/* Rates at the stage's states in b->at, at c of the step. */
static void stage_rates(block_t *b, int stage, double c)
{
    set_inputs_at(b, c);
    rates(b->c, INPUTS(b), b->at, b->k[stage]);
}

/* ---- the global error -----------------------------------------------------------------------
 *
 * A local tolerance says nothing about it: near a saddle it grows out of all proportion.  Squares
 * are summed, as local errors have no common sign. */

#if PLANE && !VARYING
/* Along the motion: the velocity f(x(t)) of an autonomous system solves its variational equation,
 * so a local error made at s has grown by |f(t)| / |f(s)| at t, and has moved a quadrature by
 * f(t) - f(s) in the same proportion.
 * Across it: where two states drive each other and the rest follows, the area between the velocity
 * and an error grows by the exp of the integral of the trace of J (Liouville), so an error across
 * has grown by that over |f(t)| / |f(s)|.
 *
 * At rest for good |f| fades to nothing, and rounding errors over it mean nothing either. */
static const double ACROSS = 0.3;
static const double REST = 1e-9;           /* scales per t_end: slower than that is at rest */

/* Rates at the beginning of a step, and the derivative along the mode. */
static void first_stage(block_t *b)
{
    lanes turn[ND1];
    turns(b->c, b->x, b->method.mode, b->k[0], turn, b->errors.trace);
    cap(b, turn);
}

/* exp(x), within a fifth for |x| < 3 and bounded beyond. */
INLINE double exponential_bound(double x)
{
    const double z = fabs(x), p = 1.0 + z * (1.0 + z * (1.0 / 2 + z * (1.0 / 6 + z / 24)));
    return x < 0.0 ? 1.0 / p : p;
}

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    const double rest = REST / t_end;
    LANE_LOOP {
        const double local = b->error[l] <= b->tau[l] ? b->method.local[l] : 0.0;
        const double head = larger(b->method.head[l], rest), tail = b->method.tail[l], per_head = 1.0 / head;
        const double trace = e->trace[l], shift = local * per_head, side = local * head;
        const double grown = exponential_bound(0.5 * e->passed[l] * (e->spread[l] + trace));
        const double area = e->area[l] * grown * grown, across = ACROSS * per_head;
        const double along = local > 0.0 ? (e->drift[l] + shift * shift) * tail * tail : 0.0;
        e->doubt[l] = larger(e->doubt[l], larger(along, area * across * across));
        e->shift[l] = shift * shift;
        e->drift[l] += shift * shift;
        e->area[l] = area + side * side;
        e->passed[l] = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        e->spread[l] = trace;
    }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double s = e->shift[l], w = b->weight[j][l];
            const double first = b->k[0][j][l], last = b->k[STAGES - 1][j][l];
            const double past = e->past[j][l] + s * first;
            const double past2 = e->past2[j][l] + s * first * first;
            const double moved = last * (e->drift[l] * last - 2.0 * past) + past2;
            e->past[j][l] = past;
            e->past2[j][l] = past2;
            e->doubt[l] = larger(e->doubt[l], s > 0.0 ? moved * w * w : 0.0);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    const errors_t *e = &b->errors;
    const double grown = exponential_bound(e->passed[l] * e->spread[l]);
    const double across = ACROSS * grown / larger(b->method.tail[l], REST / t_end);
    return sqrt(larger(e->doubt[l], e->area[l] * across * across));
}

static void forget_error(errors_t *e, int l)
{
    for (int j = 0; j < NS; ++j)
        e->past[j][l] = e->past2[j][l] = 0.0;
    e->drift[l] = e->area[l] = e->passed[l] = e->spread[l] = e->doubt[l] = 0.0;
}

#else
/* An error is carried along by the linearised motion, e' = J e, and each step adds its own in the
 * direction in which its estimate points.  Over a step J is what it is at the beginning; its
 * exponential acts within the plane of e and the fast mode that `cap` follows, where all that
 * grows or dies out quickly is found, and what of J e leaves that plane is added as it is. */
static const double BLAME = 1.0;           /* estimated error / length of e */

/* Rates at the beginning of a step, and the derivatives along the error and the mode. */
static void first_stage(block_t *b)
{
    errors_t *e = &b->errors;
    set_inputs_at(b, 0.0);
    memcpy(e->mode, b->method.mode, sizeof e->mode);
    turns(b->c, INPUTS(b), b->x, e->e, e->mode, b->k[0], e->image, e->turn);
    /* a derivative that does not exist, as of |x| at 0, says nothing */
    for (int j = 0; j < NS; ++j)
        LANE_LOOP e->image[j][l] = e->image[j][l] - e->image[j][l] == 0.0 ? e->image[j][l] : 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP e->turn[j][l] = e->turn[j][l] - e->turn[j][l] == 0.0 ? e->turn[j][l] : 0.0;
    cap(b, e->turn);
}

/* What the exponential of h times a matrix of two rows makes of (1, 0). */
INLINE void exponential(double a11, double a12, double a21, double a22, double h, double *one,
    double *two)
{
    const double half = 0.5 * h * (a11 + a22), part = 0.5 * h * (a11 - a22);
    const double root = part * part + h * h * a12 * a21, y = smaller(sqrt(fabs(root)), 20.0);
    const double up = lane_exp(y), down = 1.0 / up, flat = y < 1e-3 ? 1.0 : 0.0;
    const double even = root > 0.0 ? 0.5 * (up + down) : lane_cos(y);
    const double odd = root > 0.0 ? 0.5 * (up - down) : lane_sin(y);
    const double per_y = flat > 0.0 ? 1.0 + root / 6.0 : odd / larger(y, 1e-3);
    const double size = lane_exp(larger(smaller(half, 20.0), -40.0));
    *one = size * (even + part * per_y);
    *two = size * h * a21 * per_y;
}

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    lanes ee, er, em, mm, rm, et, mt, own, side, drift, scale;
    LANE_LOOP ee[l] = er[l] = em[l] = mm[l] = rm[l] = et[l] = mt[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], error = w * e->e[j][l], image = w * e->image[j][l];
            const double mode = w * e->mode[j][l], turn = w * e->turn[j][l];
            ee[l] += error * error;
            er[l] += error * image;
            em[l] += error * mode;
            mm[l] += mode * mode;
            rm[l] += image * mode;
            et[l] += error * turn;
            mt[l] += mode * turn;
        }
    LANE_LOOP {
        /* with q1 = e / |e| and q2 what of the mode is square to it */
        const double some = ee[l] > 0.0 ? 1.0 : 0.0, per_e = some / (ee[l] + DBL_MIN);
        const double part = em[l] * per_e, left = mm[l] - part * em[l];
        const double good = left > 1e-10 * mm[l] ? 1.0 : 0.0, per_left = good / (left + DBL_MIN);
        const double a11 = er[l] * per_e;
        /* a21 |e| / |q2| and a12 |q2| / |e| */
        const double a21 = (rm[l] - part * er[l]) * per_left;
        const double a12 = good * (et[l] - part * er[l]) * per_e;
        const double a22 = (mt[l] - part * (et[l] + rm[l]) + part * part * er[l]) * per_left;
        const double h = b->error[l] <= b->tau[l] ? b->h[l] : 0.0;
        double one, two;
        exponential(a11, a12, a21, a22, h, &one, &two);
        const double x = larger(smaller(h * a11, 3.0), -30.0);
        const double phi = fabs(x) < 1e-3 ? 1.0 + 0.5 * x : (lane_exp(x) - 1.0) / (fabs(x) < 1e-3 ? 1.0 : x);
        drift[l] = h * phi;
        own[l] = one - two * part - drift[l] * (a11 - a21 * part);
        side[l] = two - drift[l] * a21;
        ee[l] = em[l] = 0.0;
        scale[l] = h > 0.0 ? b->method.local[l] / sqrt(b->method.sharp[l] + DBL_MIN) : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            const double moved = own[l] * e->e[j][l] + side[l] * e->mode[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            const double moved = e->e[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    LANE_LOOP {
        /* the sum points where both do, and is as long as two sides of a right angle */
        const double local = scale[l] > 0.0 ? b->method.local[l] : 0.0, sum = ee[l] + local * local;
        e->doubt[l] = larger(e->doubt[l], sum);
        own[l] = sqrt(sum / (sum + 2.0 * fabs(em[l]) + DBL_MIN));
        scale[l] = em[l] < 0.0 ? -scale[l] : scale[l];
    }
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double add = scale[l] != 0.0 ? scale[l] * b->method.e5[j][l] : 0.0;
            e->e[j][l] = own[l] * (e->e[j][l] + add);
        }
}

/* The estimated global error of a lane that has come to its end. */
static double estimate(const block_t *b, int l, double t_end)
{
    return BLAME * sqrt(b->errors.doubt[l]);
}

static void forget_error(errors_t *e, int l)
{
    for (int j = 0; j < NS; ++j)
        e->e[j][l] = 0.0;
    e->doubt[l] = 0.0;
}
#endif


static void stage1(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.05260015195876773 * b->k[0][j][l]);
    stage_rates(b, 1, 0.05260015195876773);
}

static void stage2(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.0197250569845379 * b->k[0][j][l] + 0.0591751709536137 * b->k[1][j][l]);
    stage_rates(b, 2, 0.0789002279381516);
}

static void stage3(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.02958758547680685 * b->k[0][j][l] + 0.08876275643042054 * b->k[2][j][l]);
    stage_rates(b, 3, 0.1183503419072274);
}

static void stage4(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.2413651341592667 * b->k[0][j][l] + -0.8845494793282861 * b->k[2][j][l] + 0.924834003261792 * b->k[3][j][l]);
    stage_rates(b, 4, 0.2816496580927726);
}

static void stage5(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.037037037037037035 * b->k[0][j][l] + 0.17082860872947386 * b->k[3][j][l] + 0.12546768756682242 * b->k[4][j][l]);
    stage_rates(b, 5, 0.3333333333333333);
}

static void stage6(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.037109375 * b->k[0][j][l] + 0.17025221101954405 * b->k[3][j][l] + 0.06021653898045596 * b->k[4][j][l] + -0.017578125 * b->k[5][j][l]);
    stage_rates(b, 6, 0.25);
}

static void stage7(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.03709200011850479 * b->k[0][j][l] + 0.17038392571223998 * b->k[3][j][l] + 0.10726203044637328 * b->k[4][j][l] + -0.015319437748624402 * b->k[5][j][l] + 0.008273789163814023 * b->k[6][j][l]);
    stage_rates(b, 7, 0.3076923076923077);
}

static void stage8(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.6241109587160757 * b->k[0][j][l] + -3.3608926294469414 * b->k[3][j][l] + -0.868219346841726 * b->k[4][j][l] + 27.59209969944671 * b->k[5][j][l] + 20.154067550477894 * b->k[6][j][l] + -43.48988418106996 * b->k[7][j][l]);
    stage_rates(b, 8, 0.6512820512820513);
}

static void stage9(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.47766253643826434 * b->k[0][j][l] + -2.4881146199716677 * b->k[3][j][l] + -0.590290826836843 * b->k[4][j][l] + 21.230051448181193 * b->k[5][j][l] + 15.279233632882423 * b->k[6][j][l] + -33.28821096898486 * b->k[7][j][l] + -0.020331201708508627 * b->k[8][j][l]);
    stage_rates(b, 9, 0.6);
}

static void stage10(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (-0.9371424300859873 * b->k[0][j][l] + 5.186372428844064 * b->k[3][j][l] + 1.0914373489967295 * b->k[4][j][l] + -8.149787010746927 * b->k[5][j][l] + -18.52006565999696 * b->k[6][j][l] + 22.739487099350505 * b->k[7][j][l] + 2.4936055526796523 * b->k[8][j][l] + -3.0467644718982196 * b->k[9][j][l]);
    stage_rates(b, 10, 0.8571428571428571);
}

static void stage11(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (2.273310147516538 * b->k[0][j][l] + -10.53449546673725 * b->k[3][j][l] + -2.0008720582248625 * b->k[4][j][l] + -17.9589318631188 * b->k[5][j][l] + 27.94888452941996 * b->k[6][j][l] + -2.8589982771350235 * b->k[7][j][l] + -8.87285693353063 * b->k[8][j][l] + 12.360567175794303 * b->k[9][j][l] + 0.6433927460157636 * b->k[10][j][l]);
    stage_rates(b, 11, 1.0);
}

static void stage12(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->xn[j][l];
    stage_rates(b, 12, 1.0);
}

static void stage13(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.056167502283047954 * b->k[0][j][l] + 0.25350021021662483 * b->k[6][j][l] + -0.2462390374708025 * b->k[7][j][l] + -0.12419142326381637 * b->k[8][j][l] + 0.15329179827876568 * b->k[9][j][l] + 0.00820105229563469 * b->k[10][j][l] + 0.007567897660545699 * b->k[11][j][l] + -0.008298 * b->k[12][j][l]);
    stage_rates(b, 13, 0.1);
}

static void stage14(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (0.03183464816350214 * b->k[0][j][l] + 0.028300909672366776 * b->k[5][j][l] + 0.053541988307438566 * b->k[6][j][l] + -0.05492374857139099 * b->k[7][j][l] + -0.00010834732869724932 * b->k[10][j][l] + 0.0003825710908356584 * b->k[11][j][l] + -0.00034046500868740456 * b->k[12][j][l] + 0.1413124436746325 * b->k[13][j][l]);
    stage_rates(b, 14, 0.2);
}

static void stage15(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + b->h[l] * (-0.42889630158379194 * b->k[0][j][l] + -4.697621415361164 * b->k[5][j][l] + 7.683421196062599 * b->k[6][j][l] + 4.06898981839711 * b->k[7][j][l] + 0.3567271874552811 * b->k[8][j][l] + -0.0013990241651590145 * b->k[12][j][l] + 2.9475147891527724 * b->k[13][j][l] + -9.15095847217987 * b->k[14][j][l]);
    stage_rates(b, 15, 0.7777777777777778);
}

static void attempt(block_t *b, const job_t *job)
{
    first_stage(b);
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
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            b->xn[j][l] = b->x[j][l] + b->h[l] * (0.054293734116568765 * b->k[0][j][l] + 4.450312892752409 * b->k[5][j][l] + 1.8915178993145003 * b->k[6][j][l] + -5.801203960010585 * b->k[7][j][l] + 0.3111643669578199 * b->k[8][j][l] + -0.1521609496625161 * b->k[9][j][l] + 0.20136540080403034 * b->k[10][j][l] + 0.04471061572777259 * b->k[11][j][l]);
            b->method.e5[j][l] = 0.01312004499419488 * b->k[0][j][l] + -1.2251564463762044 * b->k[5][j][l] + -0.4957589496572502 * b->k[6][j][l] + 1.6643771824549864 * b->k[7][j][l] + -0.35032884874997366 * b->k[8][j][l] + 0.3341791187130175 * b->k[9][j][l] + 0.08192320648511571 * b->k[10][j][l] + -0.022355307863886294 * b->k[11][j][l];
            b->method.e3[j][l] = -0.18980075407240762 * b->k[0][j][l] + 4.450312892752409 * b->k[5][j][l] + 1.8915178993145003 * b->k[6][j][l] + -5.801203960010585 * b->k[7][j][l] + -0.4226823213237919 * b->k[8][j][l] + -0.1521609496625161 * b->k[9][j][l] + 0.20136540080403034 * b->k[10][j][l] + 0.02265179219836082 * b->k[11][j][l];
        }
}

static void prepare_dense(block_t *b)
{
    stage12(b);
    stage13(b);
    stage14(b);
    stage15(b);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l], move = b->xn[j][l] - b->x[j][l];
            const double slope = h * b->k[0][j][l];
            b->d[0][j][l] = move;
            b->d[1][j][l] = slope - move;
            b->d[2][j][l] = 2.0 * move - (h * b->k[12][j][l] + slope);
            b->d[3][j][l] = h * (-8.428938276109013 * b->k[0][j][l] + 0.5667149535193777 * b->k[5][j][l] + -3.0689499459498917 * b->k[6][j][l] + 2.38466765651207 * b->k[7][j][l] + 2.117034582445028 * b->k[8][j][l] + -0.871391583777973 * b->k[9][j][l] + 2.2404374302607883 * b->k[10][j][l] + 0.6315787787694688 * b->k[11][j][l] + -0.08899033645133331 * b->k[12][j][l] + 18.148505520854727 * b->k[13][j][l] + -9.194632392478356 * b->k[14][j][l] + -4.436036387594894 * b->k[15][j][l]);
            b->d[4][j][l] = h * (10.427508642579134 * b->k[0][j][l] + 242.28349177525817 * b->k[5][j][l] + 165.20045171727028 * b->k[6][j][l] + -374.5467547226902 * b->k[7][j][l] + -22.113666853125306 * b->k[8][j][l] + 7.733432668472264 * b->k[9][j][l] + -30.674084731089398 * b->k[10][j][l] + -9.332130526430229 * b->k[11][j][l] + 15.697238121770845 * b->k[12][j][l] + -31.139403219565178 * b->k[13][j][l] + -9.35292435884448 * b->k[14][j][l] + 35.81684148639408 * b->k[15][j][l]);
            b->d[5][j][l] = h * (19.985053242002433 * b->k[0][j][l] + -387.0373087493518 * b->k[5][j][l] + -189.17813819516758 * b->k[6][j][l] + 527.8081592054236 * b->k[7][j][l] + -11.57390253995963 * b->k[8][j][l] + 6.8812326946963 * b->k[9][j][l] + -1.0006050966910838 * b->k[10][j][l] + 0.7777137798053443 * b->k[11][j][l] + -2.778205752353508 * b->k[12][j][l] + -60.19669523126412 * b->k[13][j][l] + 84.32040550667716 * b->k[14][j][l] + 11.99229113618279 * b->k[15][j][l]);
            b->d[6][j][l] = h * (-25.69393346270375 * b->k[0][j][l] + -154.18974869023643 * b->k[5][j][l] + -231.5293791760455 * b->k[6][j][l] + 357.6391179106141 * b->k[7][j][l] + 93.40532418362432 * b->k[8][j][l] + -37.45832313645163 * b->k[9][j][l] + 104.0996495089623 * b->k[10][j][l] + 29.8402934266605 * b->k[11][j][l] + -43.53345659001114 * b->k[12][j][l] + 96.32455395918828 * b->k[13][j][l] + -39.17726167561544 * b->k[14][j][l] + -149.72683625798564 * b->k[15][j][l]);
        }
}


/* The interpolation's error: its last term, made smaller as the next one would be (h |eigenvalue|).
 * It may use up tol, while the error of the step stays below tau. */
static void measure_between(block_t *b, double tol)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double s = larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e = BETWEEN * (b->h[l] * b->method.rho[l] + 0.5) * fabs(b->d[6][j][l]) / s;
            b->error[l] = larger(b->error[l], e * b->tau[l] / tol);
        }
}

/* The step's error, and the velocity at its two ends, relative to each state's scale so far.  The
 * error is Hairer's combination of the two estimates of DOP853; the square of the third-order one,
 * which falls with the same power of h, guards against a fifth-order one that is zero by chance. */
static void measure(block_t *b, double tol, int between)
{
    lanes five, three;
    LANE_LOOP five[l] = three[l] = b->method.head[l] = b->method.tail[l] = 0.0;
    for (int j = 0; j < NS; ++j) {
        const double moves = j < ND ? 1.0 : 0.0;
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e5 = b->method.e5[j][l] * w, e3 = b->method.e3[j][l] * w;
            b->weight[j][l] = w;
            five[l] += e5 * e5;
            three[l] += e3 * e3;
            b->method.head[l] = larger(b->method.head[l], moves * w * fabs(b->k[0][j][l]));
            b->method.tail[l] = larger(b->method.tail[l], moves * w * fabs(b->k[STAGES - 1][j][l]));
        }
    }
    LANE_LOOP {
        const double h = b->h[l];
        const double pair = h * five[l] / sqrt(five[l] + 0.01 * three[l] + DBL_MIN);
        b->method.local[l] = b->error[l] = larger(pair, GUARD * h * h * three[l]);
        b->method.sharp[l] = five[l];
    }
    if (between)
        measure_between(b, tol);
}

/* x^(-1/8), within 0.5 %: Newton from a guess by the exponent. */
INLINE double inverse_root(double x)
{
    const double y = from_bits(5182826893670980608 - (bits(x) >> 3)), y2 = y * y, y4 = y2 * y2;
    return y * (1.125 - 0.125 * x * y4 * y4);
}

/* How much longer the next step may be. */
INLINE double next_factor(block_t *b, int l, double ratio)
{
    return SAFETY * inverse_root(smaller(ratio, 1e30) + 1e-30);
}

/* State j of lane l at a fraction of the step. */
INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s;
    const double end = b->d[5][j][l] + s * b->d[6][j][l];
    const double inner = b->d[3][j][l] + s * (b->d[4][j][l] + r * end);
    return b->x[j][l] + s * (b->d[0][j][l] + r * (b->d[1][j][l] + s * (b->d[2][j][l] + r * inner)));
}

/* Put lane l at the beginning of its trajectory. */
static void begin_method(block_t *b, int l, double tau)
{
    if (b->tau[l] != tau)
        b->method.reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->method.growth[l] = b->method.rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->method.mode[j][l] = b->f0[j][l];
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
#if VARYING
        const double goal = smaller(t_end, b->in.until[l]);
#else
        const double goal = t_end;
#endif
        const double ratio = b->error[l] / b->tau[l];
        const double wish = next_factor(b, l, ratio);
        const double factor = ratio == ratio ? larger(smaller(wish, GROW), SHRINK) : SHRINK;
        const double past = b->h[l] >= goal - b->t[l] ? goal : b->t[l] + b->h[l];
        const double t = ratio <= 1.0 ? past : b->t[l], rest = goal - t, h = b->h[l] * factor;
        const double steps = b->steps[l] + 1.0;
        const double stuck = ratio == ratio ? (double)STEP_LIMIT : (double)NON_FINITE;
#if VARYING
        /* a step cut short by a break says little about the next one */
        const double size = ratio <= 1.0 && b->h[l] < b->wish[l] ? larger(h, b->wish[l]) : h;
        b->wish[l] = size;
#else
        const double size = h;
#endif
        double state = b->state[l];
        state = steps >= max_steps ? (double)STEP_LIMIT : state;
        state = size < b->least[l] ? stuck : state;
        state = t >= t_end && state < 0.0 ? (double)OK : state;
        b->t[l] = t;
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
        b->steps[l] = steps;
        b->state[l] = state;
        ended += state >= 0.0 ? 1.0 : 0.0;
    }
    return ended > 0.0;
}

#if VARYING
/* Go on with the next polynomials where they begin. */
static void turn_pages(block_t *b, const job_t *job)
{
    double turned = 0.0;
#pragma omp simd reduction(+ : turned)
    for (int l = 0; l < LANES; ++l)
        turned += b->t[l] >= b->in.until[l] ? 1.0 : 0.0;
    for (int l = 0; turned > 0.0 && l < LANES; ++l) {
        if (!(b->t[l] >= b->in.until[l]) || b->id[l] < 0)
            continue;
        enter(&b->in, l, job, b->id[l], b->t[l]);
        const double rest = smaller(job->t_end, b->in.until[l]) - b->t[l], h = b->wish[l];
        b->h[l] = h >= rest ? rest : (h + h > rest ? 0.5 * rest : h);
    }
}
#endif

/* ---- between the steps ------------------------------------------------------------------- */

/* Whether lane l has made a step. */
INLINE int stepped(const block_t *b, int l) { return b->id[l] >= 0 && b->error[l] <= b->tau[l]; }

/* States and outputs of one lane at the sample times within its step. */
static void sample_lane(const block_t *b, const job_t *job, int l, int64_t begin, int64_t end)
{
    double at[NS][TILE], y[NY1][TILE];
#if VARYING
    double u[NU1][TILE];
#else
    double (*u)[TILE] = NULL;
#endif
    const double per_step = 1.0 / b->h[l];
    for (int64_t from = begin; from < end; from += TILE) {
        const int count = end - from < TILE ? (int)(end - from) : TILE;
        for (int j = 0; j < NS; ++j) {
#pragma omp simd
            for (int s = 0; s < count; ++s)
                at[j][s] = dense(b, j, l, (job->times[from + s] - b->t[l]) * per_step);
        }
        if (job->observed) {
#if VARYING
            inputs_row(&b->in, b->terms, l, job->times + from, u, count);
#endif
            observe_row(b->c, l, u, at, y, count);
        }
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + b->id[l] * job->n_times + from, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
    }
}

/* A step gives the samples before its end, as an input may jump there and what follows counts; the
 * last step gives all that are left. */
static void sample(block_t *b, const job_t *job)
{
    for (int l = 0; l < LANES; ++l) {
        if (!stepped(b, l))
            continue;
        const int cut = b->cause[l] >= 0, last = cut || b->h[l] >= job->t_end - b->t[l];
        const double end = cut ? b->finish[l] : (last ? job->t_end : b->t[l] + b->h[l]);
        const int64_t begin = b->next[l];
        int64_t next = begin;
        while (next < job->n_times && (job->times[next] < end || (last && job->times[next] == end)))
            ++next;
        b->next[l] = next;
        if (next > begin)
            sample_lane(b, job, l, begin, next);
    }
}

/* ---- events ---------------------------------------------------------------------------------
 *
 * Of each watched row the largest value, and the first time at which it is not below its limit,
 * which may end the trajectory.  The two never contradict each other: where a maximum is found that
 * reaches the limit, the time is sought on the way to it, and a maximum that misses the limit by
 * less than the tolerance is said to reach it.
 *
 * Places are fractions of the step, or of what of it the trajectory goes (b->stop). */

/* Values of watch i at a place of each lane's step. */
static void watch_at(block_t *b, const job_t *job, int i, const double *place, double *value)
{
    const int64_t row = job->watches[i].row;
    const double sign = (double)job->watches[i].sign;
    LANE_LOOP b->theta[l] = place[l] * b->stop[l];
    for (int j = 0; j < NS; ++j)
        if (row >= NS || j == row)
            LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
    if (row >= NS) {
        set_inputs(b, b->theta);
        observe_lanes(b->c, INPUTS(b), b->at, b->y);
    }
    const double *from = row < NS ? b->at[row] : b->y[row - NS];
    LANE_LOOP value[l] = sign == 0.0 ? fabs(from[l]) : sign * from[l];
}

/* Values of all that is watched at NODES equal parts. */
static void look(block_t *b, const job_t *job, lanes (*node)[NODES + 1])
{
    for (int m = 0; m <= NODES; ++m) {
        LANE_LOOP b->theta[l] = b->stop[l] * ((double)m / NODES);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP b->at[j][l] = dense(b, j, l, b->theta[l]);
        if (job->observed) {
            set_inputs(b, b->theta);
            observe_lanes(b->c, INPUTS(b), b->at, b->y);
        }
        for (int i = 0; i < job->n_watches; ++i) {
            const int64_t row = job->watches[i].row;
            const double *from = row < NS ? b->at[row] : b->y[row - NS];
            const double sign = (double)job->watches[i].sign;
            LANE_LOOP node[i][m][l] = sign == 0.0 ? fabs(from[l]) : sign * from[l];
        }
    }
}

/* Vertex of the parabola through three points at -1, 0, 1, within these; `without` if it has no
 * maximum. */
INLINE double vertex(double left, double middle, double right, double without)
{
    const double bend = left - 2.0 * middle + right, v = 0.5 * (left - right) / bend;
    return bend < 0.0 ? larger(-1.0, smaller(1.0, v)) : without;
}

/* Where the maximum beside node m is by the parabola there, and how high. */
INLINE double summit(const lanes *node, int l, int m, double *top)
{
    const int k = m == 0 ? 1 : (m == NODES ? NODES - 1 : m);
    const double left = node[k - 1][l], middle = node[k][l], right = node[k + 1][l];
    const double v = vertex(left, middle, right, m - k);
    *top = middle + 0.5 * v * (right - left + v * (left - 2.0 * middle + right));
    return (k + v) / NODES;
}

/* The maxima near places, by parabolas of width 1/8, 1/64, 1/512 step. */
static void climb(block_t *b, const job_t *job, int i, double *place, double *top)
{
    lanes at, left, right;
    double width = 1.0 / NODES;
    for (int round = 0; round < 3; ++round) {
        width /= 8.0;
        LANE_LOOP place[l] = larger(smaller(place[l], 1.0 - width), width);
        watch_at(b, job, i, place, top);
        LANE_LOOP at[l] = place[l] - width;
        watch_at(b, job, i, at, left);
        LANE_LOOP at[l] = place[l] + width;
        watch_at(b, job, i, at, right);
        LANE_LOOP place[l] += width * vertex(left[l], top[l], right[l], 0.0);
    }
    watch_at(b, job, i, place, top);
}

/* The largest value of each lane, and its place; sought between the nodes where it may be above
 * those of earlier steps. */
static void find_largest(block_t *b, const job_t *job, int i, const lanes *node, double *place,
    double *top)
{
    lanes there, height, least;
    int climbing[LANES], inside = 0;
    LANE_LOOP top[l] = least[l] = node[0][l], place[l] = 0.0;
    for (int m = 1; m <= NODES; ++m)
        LANE_LOOP {
            const double value = node[m][l];
            place[l] = value > top[l] ? (double)m / NODES : place[l];
            top[l] = larger(value, top[l]);
            least[l] = smaller(value, least[l]);
        }
    for (int l = 0; l < LANES; ++l) {
        there[l] = summit(node, l, (int)(place[l] * NODES), &height[l]);
        climbing[l] = top[l] + 0.05 * (top[l] - least[l]) > b->largest[i][l] && stepped(b, l)
                      && there[l] > 0.0 && there[l] < 1.0;
        inside |= climbing[l];
    }
    if (!inside)
        return;
    climb(b, job, i, there, height);
    for (int l = 0; l < LANES; ++l)
        if (climbing[l] && height[l] > top[l])
            top[l] = height[l], place[l] = there[l];
}

/* Close in on where watch i reaches its limits, between places below them and not below them:
 * inverse quadratic interpolation where it is safe and halves where not (Chandrupatla, Adv. Eng.
 * Software 28, 1997, 145).  The limit is reached at `high`. */
static void find_crossing(block_t *b, const job_t *job, int i, const double *limit, double *low,
    double *high)
{
    lanes x, f, f_low, f_high, share;       /* low and high are on either side, x is the newest */
    watch_at(b, job, i, low, f_low);
    watch_at(b, job, i, high, f_high);
    LANE_LOOP {
        f_low[l] -= limit[l];
        f_high[l] -= limit[l];
        share[l] = 0.5;
    }
    for (int round = 0; round < 60; ++round) {
        double widest = 0.0;
        LANE_LOOP x[l] = low[l] + share[l] * (high[l] - low[l]);
        watch_at(b, job, i, x, f);
#pragma omp simd reduction(max : widest)
        for (int l = 0; l < LANES; ++l) {
            /* a lane that is there already stays, however long the others take */
            const double done = high[l] - low[l] < 1e-12 ? 1.0 : 0.0;
            const double fx = f[l] - limit[l], over = fx >= 0.0 ? 1.0 : 0.0;
            /* newest, other side, and the one that is replaced */
            const double other = over > 0.0 ? low[l] : high[l], f_other = over > 0.0 ? f_low[l] : f_high[l];
            const double old = over > 0.0 ? high[l] : low[l], f_old = over > 0.0 ? f_high[l] : f_low[l];
            const double xi = (x[l] - other) / (old - other), phi = (fx - f_other) / (f_old - f_other);
            const double back = 1.0 - phi, rest = 1.0 - xi;
            const double a = fx / (f_other - fx) * f_old / (f_other - f_old);
            const double c = fx / (f_old - fx) * f_other / (f_old - f_other);
            const double t = a + (old - x[l]) / (other - x[l]) * c;
            const int safe = (phi * phi < xi) & (back * back < rest);
            low[l] = over > done ? low[l] : (done > 0.0 ? low[l] : x[l]);
            f_low[l] = over > done ? f_low[l] : (done > 0.0 ? f_low[l] : fx);
            high[l] = over > done ? x[l] : high[l];
            f_high[l] = over > done ? fx : f_high[l];
            const double width = high[l] - low[l], least = smaller(0.5, 1e-13 / larger(width, 1e-15));
            const double step = safe ? t : 0.5, next = over > 0.0 ? 1.0 - step : step;
            share[l] = larger(least, smaller(1.0 - least, next));
            widest = larger(widest, width);
        }
        if (widest < 1e-12)
            return;
    }
}

/* The earliest node from m on beside which watch i may reach a limit; past the last if none. */
INLINE int candidate(const lanes *node, int l, int m, double limit, double slack)
{
    for (; m <= NODES; ++m) {
        double top;
        summit(node, l, m, &top);
        const int peak = (m == 0 || node[m][l] >= node[m - 1][l]) && (m == NODES || node[m][l] >= node[m + 1][l]);
        if (node[m][l] >= limit || (peak && top + slack >= limit))
            break;
    }
    return m;
}

/* Of watch i in this step: the largest value, and the place where it first is not below its limit,
 * infinite if nowhere. */
static void look_closer(block_t *b, const job_t *job, int i, const lanes *node, double *when,
    double *top)
{
    lanes place, there, height, low, high, limit, slack;
    const watch_t *w = &job->watches[i];
    int from[LANES], open[LANES], pending = 0, crossing = 0;
    find_largest(b, job, i, node, place, top);
    for (int l = 0; l < LANES; ++l) {
        const double far = larger(fabs(top[l]), fabs(node[0][l]));
        limit[l] = b->id[l] >= 0 ? w->limit[b->id[l] * w->limit_stride] : INFINITY;
        b->size[i][l] = far > b->size[i][l] ? far : b->size[i][l];
        slack[l] = job->tol * b->size[i][l];
        when[l] = INFINITY;
        low[l] = high[l] = 0.0;
        const int near = top[l] + 0.02 * b->size[i][l] + slack[l] >= limit[l];
        open[l] = near && stepped(b, l) && b->first[i][l] == INFINITY;
        from[l] = open[l] ? candidate(node, l, 0, limit[l], 0.02 * b->size[i][l]) : NODES + 1;
        pending |= open[l];
    }
    while (pending) {
        int climbing = 0;
        for (int l = 0; l < LANES; ++l) {
            const int peak = open[l] && from[l] <= NODES && node[from[l]][l] < limit[l];
            there[l] = peak ? summit(node, l, from[l], &height[l]) : place[l];
            climbing |= peak;
        }
        if (climbing)
            climb(b, job, i, there, height);
        pending = 0;
        for (int l = 0; l < LANES; ++l) {
            if (!open[l])
                continue;
            const int m = from[l], last = m > NODES, over = !last && node[m][l] >= limit[l];
            const double value = last ? top[l] : (over ? node[m][l] : height[l]);
            const double here = last ? place[l] : (over ? (double)m / NODES : there[l]);
            open[l] = !last && value < limit[l] - slack[l];
            if (open[l]) {
                from[l] = candidate(node, l, m + 1, limit[l], 0.02 * b->size[i][l]);
                pending = 1;
            } else if (value >= limit[l] - slack[l]) {
                top[l] = larger(top[l], larger(value, limit[l]));
                when[l] = low[l] = high[l] = here;
                for (int k = 0; k <= NODES && (double)k / NODES < here; ++k)
                    low[l] = value >= limit[l] && node[k][l] < limit[l] ? (double)k / NODES : low[l];
                crossing |= low[l] < high[l];
            }
        }
    }
    if (!crossing)
        return;
    find_crossing(b, job, i, limit, low, high);
    LANE_LOOP when[l] = when[l] < INFINITY ? high[l] : INFINITY;
}

/* Extremes and events of the step; where one ends the trajectory, b->cause says which, b->finish
 * when, and the new states are those there. */
static void watch(block_t *b, const job_t *job)
{
    lanes node[WATCHES][NODES + 1], when, top;
    int cut = 0;
    LANE_LOOP b->stop[l] = 1.0;
    look(b, job, node);
    lanes stop;
    LANE_LOOP stop[l] = INFINITY;
    for (int i = 0; i < job->n_watches; ++i) {
        if (!job->watches[i].ends)
            continue;
        look_closer(b, job, i, node[i], when, top);
        for (int l = 0; l < LANES; ++l)
            if (when[l] < stop[l]) {
                stop[l] = when[l];
                b->cause[l] = i;
                b->finish[l] = b->t[l] + stop[l] * b->h[l];
                cut = 1;
            }
    }
    if (cut) {
        LANE_LOOP b->stop[l] = smaller(stop[l], 1.0);
        look(b, job, node);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP b->xn[j][l] = stop[l] <= 1.0 ? b->at[j][l] : b->xn[j][l];
    }
    for (int i = 0; i < job->n_watches; ++i) {
        look_closer(b, job, i, node[i], when, top);
        for (int l = 0; l < LANES; ++l) {
            if (!stepped(b, l))
                continue;
            double first = b->t[l] + when[l] * b->stop[l] * b->h[l];
            if (b->cause[l] == i) {
                const watch_t *w = &job->watches[i];
                top[l] = larger(top[l], w->limit[b->id[l] * w->limit_stride]);
                first = b->finish[l];
            }
            b->largest[i][l] = top[l] > b->largest[i][l] ? top[l] : b->largest[i][l];
            b->first[i][l] = smaller(b->first[i][l], first);
        }
    }
}

/* Trajectories that an event has ended are at their end; says whether there are any. */
static int finish(block_t *b)
{
    int ended = 0;
    for (int l = 0; l < LANES; ++l)
        if (b->id[l] >= 0 && b->cause[l] >= 0) {
            b->t[l] = b->finish[l];
            b->state[l] = OK;
            ended = 1;
        }
    return ended;
}


/* ---- loading and unloading ---------------------------------------------------------------- */

static void queue_rates(queue_t *q, int k, double t, lanes *x)
{
#if VARYING
    LANE_LOOP q->when[l] = t;
    inputs_at(&q->in, TERMS, q->when, q->u);
#endif
    rates(q->c, INPUTS(q), x, q->k[k]);
}

/* First steps: an explicit Euler probe measures how fast the velocity changes. */
static void first_steps(queue_t *q, double t_end, double tau)
{
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 1.0 / ORDER);
    queue_rates(q, 0, 0.0, q->x);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP q->xn[j][l] = q->x[j][l] + probe * q->k[0][j][l];
    queue_rates(q, 1, probe, q->xn);
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
#if VARYING
        enter_first(&q->in, l, job, i);
#endif
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
static void restart(block_t *b, int l, const job_t *job, double tau, double h)
{
    for (int j = 0; j < NS; ++j) {
        b->x[j][l] = b->begin[j][l];
        b->scale[j][l] = larger(fabs(b->begin[j][l]), SCALE_FLOOR);
        b->weight[j][l] = 1.0 / b->scale[j][l];
    }
    for (int i = 0; i < job->n_watches; ++i) {
        b->largest[i][l] = -INFINITY;
        b->first[i][l] = INFINITY;
        b->size[i][l] = 0.0;
    }
    begin_method(b, l, tau);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = 0.0;
    b->state[l] = RUNNING;
    b->next[l] = 0;
    b->cause[l] = -1;
    b->stop[l] = 1.0;
    forget_error(&b->errors, l);
#if VARYING
    enter_first(&b->in, l, job, b->id[l]);
    b->wish[l] = h;
    b->h[l] = smaller(h, b->in.until[l]);
#endif
}

/* Load the queue's next trajectory into lane l, or leave the lane standing still for good. */
static int load(block_t *b, int l, queue_t *q, const job_t *job, int64_t *shared, double tau)
{
    b->id[l] = -1;
    b->state[l] = RUNNING;
    b->h[l] = 0.0;
    b->t[l] = b->least[l] = -1.0;
    b->steps[l] = -INFINITY;
    b->stop[l] = 1.0;
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
    restart(b, l, job, tau, b->h0[l]);
    return 1;
}

static void unload(const block_t *b, int l, const job_t *job)
{
    const int64_t i = b->id[l];
    const int whole = b->state[l] == OK || b->state[l] == UNSURE;
    for (int j = 0; j < NS; ++j)
        if (job->final[j])
            job->final[j][i] = whole ? b->x[j][l] : NAN;
    for (int j = 0; j < job->n_watches; ++j) {
        job->watches[j].largest[i] = b->largest[j][l];
        job->watches[j].first[i] = b->first[j][l];
    }
    for (int j = 0; job->samples && j < ROWS; ++j)
        for (int64_t s = b->next[l]; job->samples[j] && s < job->n_times; ++s)
            job->samples[j][i * job->n_times + s] = NAN;
    job->end[i] = b->t[l];
    job->cause[i] = (int8_t)b->cause[l];
    job->steps[i] = (int32_t)b->steps[l];
    job->estimate[i] = estimate(b, l, job->t_end);
    job->status[i] = (int8_t)b->state[l];
}

/* A lane has come to its end: once more with a finer tolerance if its error may be too large. */
static int retry(block_t *b, int l, const job_t *job)
{
    if (b->state[l] != OK)
        return 0;
    /* at fine tolerances estimates are larger beside the errors, as steps are closer to even */
    const double fine = pow(1e-6 / smaller(job->tol, 1e-6), 0.1), trust = smaller(TRUST * fine, 1.0);
    const double found = estimate(b, l, job->t_end), trusted = trust * job->tol;
    if (found <= trusted)
        return 0;
    if (b->retries[l] == RETRIES || b->tau[l] <= FINEST) {
        b->state[l] = UNSURE;
        return 0;
    }
    const double finer = larger(0.3 * b->tau[l] * trusted / found, FINEST);
    ++b->retries[l];
    restart(b, l, job, finer, b->h0[l] * pow(finer / b->tau[l], 1.0 / ORDER));
    return 1;
}

/* ---- the job ------------------------------------------------------------------------------ */

static void work(const job_t *job, int64_t *shared)
{
    block_t b;
    queue_t q = {.used = 0, .count = 0};
    memset(&b, 0, sizeof b);
#if VARYING
    b.terms = most_terms(job);
#endif
    const int between = job->samples || job->n_watches;
    const double tau = larger(SHARE * job->tol, FINEST);
    int running = 0;
    for (int l = 0; l < LANES; ++l)
        running += load(&b, l, &q, job, shared, tau);
    while (running) {
        attempt(&b, job);
        if (between)
            prepare_dense(&b);
        measure(&b, job->tol, between);
        if (between) {
            if (job->n_watches)
                watch(&b, job);
            if (job->samples)
                sample(&b, job);
        }
        follow_error(&b, job->t_end);
        int ended = advance(&b, job->t_end, (double)job->max_steps);
        if (job->n_watches)
            ended |= finish(&b);
#if VARYING
        turn_pages(&b, job);
#endif
        if (!ended)
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

#elif DRIVER == 2
/* One trajectory whose lanes are moments: Picard iteration on Gauss-Legendre nodes.
 *
 * A sweep computes the rates at all nodes of a step at once, which takes little longer than at
 * one, and integrates the polynomial through them for the next guess of the states.  The sweeps
 * converge to the collocation solution, whose order is 2 LANES.  They begin with the polynomial of
 * the step before, continued.  What lies between the nodes is known without further work.
 *
 * In orbit mechanics this is the modified Picard-Chebyshev iteration (Clenshaw and Norton 1963;
 * Bai and Junkins, J. Astronaut. Sci. 58, 2011); here with the nodes of Gauss.
 */
enum { MOST_SWEEPS = 32 };

static const double NODE[LANES] = {-0.9894009349916499, -0.9445750230732326, -0.8656312023878318, -0.755404408355003, -0.6178762444026438, -0.45801677765722737, -0.2816035507792589, -0.09501250983763744, 0.09501250983763744, 0.2816035507792589, 0.45801677765722737, 0.6178762444026438, 0.755404408355003, 0.8656312023878318, 0.9445750230732326, 0.9894009349916499};
static const double INTEGRAL[LANES][LANES] = {
{0.006788114852938524, 0.014688355739094638, 0.013031488757002925, 0.013914562989563872, 0.013340202736275428, 0.013752704094945637, 0.01343811900184236, 0.013687791670766909, 0.013484086053874201, 0.013653491099350889, 0.013510879903314302, 0.01363160929215658, 0.013529634903656286, 0.013614562967342187, 0.013546417734365055, 0.013595745389877631},
{-0.0025498156016664207, 0.015563380984661973, 0.03383605413802762, 0.02972001918886916, 0.03203955577869617, 0.0304689428780195, 0.03163074694638994, 0.03072505354967737, 0.0314556216268109, 0.03085269993704811, 0.03135756832006543, 0.030931775623602737, 0.03129045468216172, 0.030992300077666107, 0.031231229725586906, 0.03105841087618589},
{0.0019090991781367235, -0.00414132717596764, 0.023789627920623196, 0.0517801403483892, 0.04535510632585621, 0.049048538719911265, 0.04650437962214507, 0.048412685417913374, 0.04690897854723003, 0.04813117543226429, 0.04711832682860575, 0.047966343369355, 0.04725565771698809, 0.0478442967764949, 0.047373722199475644, 0.04771359859280501},
{-0.0015529395863544586, 0.002816240663291797, -0.005501892634002195, 0.03115724281388347, 0.06784622532815639, 0.059360391807074156, 0.06428300515834291, 0.060863467025027436, 0.06344612321341286, 0.06140114672249213, 0.06306692951485267, 0.06168855130130664, 0.06283429442816829, 0.06189066961159072, 0.06264219164523037, 0.06210061688834385},
{0.0013003863616733529, -0.00219345482567798, 0.0034965221728233374, -0.006639917364470169, 0.037398997204144184, 0.08145474794895469, 0.07122776175885592, 0.07718760470462736, 0.07303031975710489, 0.07617925858327435, 0.0736838477565867, 0.07571164524402679, 0.07404666617731809, 0.075406523698019, 0.07432943980529687, 0.07510310724702272},
{-0.001099413978104675, 0.0017874391815362418, -0.002611839691134492, 0.004009535051445654, -0.007527162113886165, 0.042289129848750634, 0.09211515189216346, 0.08052720073691026, 0.08729497416459168, 0.08256694574897395, 0.08614788038482393, 0.08331843200299985, 0.085599537396396, 0.08375889896888228, 0.0852054113264463, 0.08417113837648092},
{0.0009288103824611658, -0.0014782998956699256, 0.00206262230133837, -0.0028842281633600646, 0.004357982319235883, -0.008136028445684633, 0.045650853761230896, 0.09944286147387528, 0.08692213009978732, 0.09423914404364103, 0.08913050657175561, 0.0929877390626584, 0.08996350500408735, 0.09236080775814369, 0.09049782270018185, 0.09182129928707909},
{-0.000778400292638017, 0.0012224834918901487, -0.0016592708237987142, 0.0022057179586841263, -0.0030262384237201827, 0.004537073686656364, -0.008446427935230748, 0.047362652613767126, 0.10317333864857194, 0.09018150402832452, 0.0977679500872369, 0.09248669545997376, 0.09644552669173094, 0.09339085347665704, 0.09572609456319256, 0.09408239215447606},
{0.0006429130730581916, -0.00100078933565831, 0.0013344517508772085, -0.0017202214641966905, 0.0022386097675604934, -0.003042644859702651, 0.004543801199209732, -0.008448033421037683, 0.047362652613767126, 0.103171733162765, 0.09018823154087789, 0.09775154365125444, 0.09251958726885012, 0.09638457605133297, 0.0935028217356441, 0.09550370552017226},
{-0.0005195917646173007, 0.000803884822279941, -0.0010591002356818958, 0.001338202518374444, -0.001686031540196616, 0.0021712009507061794, -0.002937436521179236, 0.004379577422674482, -0.008141153951413483, 0.045650853761230896, 0.09943773596814642, 0.08694372520322591, 0.09418593568582186, 0.08923908522112342, 0.09278000741813172, 0.09037289714000063},
{0.00040712132102035037, -0.0006271516289450237, 0.0008193607286189948, -0.0010212776988947289, 0.0012598276945014187, -0.001569620687322662, 0.0020113139485273173, -0.0027167144670904204, 0.004051058960591014, -0.007536892194662191, 0.042289129848750634, 0.09210542181138744, 0.08056872464605562, 0.08719009938863576, 0.08279082051596502, 0.08567767367560594},
{-0.00030511283873435466, 0.0004685546029915049, -0.0006085292897306367, 0.0007513282309702764, -0.0009136508357384329, 0.0011141466517016535, -0.0013812641749859785, 0.0017676746511834718, -0.0023896102963389923, 0.0035702326494324475, -0.006656753540666324, 0.037398997204144184, 0.08143791177275854, 0.07130147223546503, 0.07699144923396635, 0.07349760804661501},
{0.00021386873942309212, -0.0003277060174634333, 0.00042381601617621996, -0.0005198088004013574, 0.0006259343264602944, -0.0007524438870857332, 0.0009133389052748065, -0.0011316375856459321, 0.0014510186027395001, -0.001968519530575974, 0.002954093820692783, -0.005531739700389444, 0.03115724281388347, 0.06781637826176913, 0.05949824496447514, 0.06386742521412139},
{-0.00013434275155861354, 0.00020553364177074726, -0.0002650409352485076, 0.00032359812425830024, -0.00038708752810860924, 0.0004609290126406437, -0.0005519195910179026, 0.0006702772940163651, -0.0008334295766669837, 0.0010748762191013248, -0.0014692828786648739, 0.002224149515390185, -0.00420088450714281, 0.023789627920623196, 0.05172058301721403, 0.04567015666310967},
{6.835109313805682e-05, -0.00010446775626296073, 0.0001344618916578405, -0.00016369271283777007, 0.00019498634572121012, -0.00023080635074148077, 0.00027406203227583754, -0.0003288596574869537, 0.00040170841964657907, -0.0005039849770659961, 0.0006578190913044469, -0.0009127938093722185, 0.0014067427804547875, -0.0027092921687036716, 0.015563380984661973, 0.033676577570990365},
{-1.9515684000583094e-05, 2.981197151199246e-05, -3.833326146514045e-05, 4.659480222076111e-05, -5.5379586279532815e-05, 6.534980256274624e-05, -7.726139347384104e-05, 9.214365200284638e-05, -0.00011156196488986195, 0.00013811070403468726, -0.00017647438906859074, 0.000236026969601619, -0.0003383332836868244, 0.0005447409488741235, -0.0011121260332175912, 0.006788114852938524}
};
static const double SERIES[LANES][LANES] = {
{0.08723948374841772, -0.17393465731009858, 0.16970325764329208, -0.16450380711003673, 0.15581718348542065, -0.14651754489639118, 0.13411200834092032, -0.12166472371231113, 0.10663837445200247, -0.09233422446709097, 0.07607276158693489, -0.061476427428896856, 0.04557690796925883, -0.03250404400373432, 0.018742155087350106, -0.009471466229970906},
{0.04132652364211716, -0.07360455803622369, 0.056397006926487823, -0.023936773797439657, -0.011176849602457198, 0.05426031329151281, -0.09132902375612588, 0.12786323836286914, -0.1502238188975248, 0.16614294839397778, -0.1636451397278681, 0.1542279917474148, -0.12771467799883723, 0.10002817046910537, -0.061253544858819654, 0.03242386436364128},
{0.0748485168729004, -0.13800603163045752, 0.0892276204482914, -0.03344240394689998, -0.0313300437697022, 0.0703192582493929, -0.09041104436918267, 0.06812480409461773, -0.027530867792536193, -0.03971475578046615, 0.0962875313901042, -0.14814148897477397, 0.16018425905941042, -0.15366147072138003, 0.10584406826305116, -0.061136929890628806},
{0.049532898962625756, -0.06221836397738761, -0.005065745066942073, 0.09529139855420667, -0.1389013400253805, 0.14056824046621524, -0.07347039702038977, -0.002487607773083915, 0.0772286967764813, -0.08535403500348358, 0.05172493184855617, 0.038895632380503656, -0.1104887961805323, 0.16469945099473335, -0.13834058648960842, 0.0915672353507071},
{0.06880246924050938, -0.10160902163389283, -0.0120413371118654, 0.0830710144032856, -0.09061387568457466, -0.005283998914805728, 0.09714359049439028, -0.1503635229963774, 0.08866850727391418, 0.0028815635149164755, -0.09222940655912272, 0.0694322200836731, 0.0064283677874472185, -0.12558143076065767, 0.14875919782276437, -0.1203794442417698},
{0.05481826578669249, -0.030275112467753742, -0.08190351266200353, 0.14547740647438087, -0.05135867320864966, -0.05732807354617773, 0.10387311223848339, 0.004978355910154048, -0.10843345330248254, 0.13992603830555905, -0.019743493047625318, -0.07175713565611758, 0.08547543714188034, 0.05141218482204977, -0.13257072359090644, 0.1447225626417121},
{0.06398256048620879, -0.05839820349915733, -0.09507483804343268, 0.06688818503792841, 0.057402937219711195, -0.14531454264397634, 0.024439245157104352, 0.0835487516700367, -0.0714944954240181, -0.09439518276047766, 0.12465853270763329, -0.03198112289471179, -0.1066465371775159, 0.02705111690520989, 0.09141115603141202, -0.16230469356380142},
{0.0594492812605283, 0.012334636864010654, -0.1212424521338276, 0.058317534012796955, 0.11016066158563234, -0.0305389811844204, -0.10435749108520001, 0.10109423592674359, 0.08514705691416369, -0.06326187328433902, -0.07312571819861241, 0.13651191218952452, 0.04718503939888862, -0.07679681948505165, -0.03259172226524315, 0.17151279510949485},
{0.0594492812605283, -0.012334636864010654, -0.1212424521338276, -0.058317534012796955, 0.11016066158563234, 0.0305389811844204, -0.10435749108520001, -0.10109423592674359, 0.08514705691416369, 0.06326187328433902, -0.07312571819861241, -0.13651191218952452, 0.04718503939888862, 0.07679681948505165, -0.03259172226524315, -0.17151279510949485},
{0.06398256048620879, 0.05839820349915733, -0.09507483804343268, -0.06688818503792841, 0.057402937219711195, 0.14531454264397634, 0.024439245157104352, -0.0835487516700367, -0.0714944954240181, 0.09439518276047766, 0.12465853270763329, 0.03198112289471179, -0.1066465371775159, -0.02705111690520989, 0.09141115603141202, 0.16230469356380142},
{0.05481826578669249, 0.030275112467753742, -0.08190351266200353, -0.14547740647438087, -0.05135867320864966, 0.05732807354617773, 0.10387311223848339, -0.004978355910154048, -0.10843345330248254, -0.13992603830555905, -0.019743493047625318, 0.07175713565611758, 0.08547543714188034, -0.05141218482204977, -0.13257072359090644, -0.1447225626417121},
{0.06880246924050938, 0.10160902163389283, -0.0120413371118654, -0.0830710144032856, -0.09061387568457466, 0.005283998914805728, 0.09714359049439028, 0.1503635229963774, 0.08866850727391418, -0.0028815635149164755, -0.09222940655912272, -0.0694322200836731, 0.0064283677874472185, 0.12558143076065767, 0.14875919782276437, 0.1203794442417698},
{0.049532898962625756, 0.06221836397738761, -0.005065745066942073, -0.09529139855420667, -0.1389013400253805, -0.14056824046621524, -0.07347039702038977, 0.002487607773083915, 0.0772286967764813, 0.08535403500348358, 0.05172493184855617, -0.038895632380503656, -0.1104887961805323, -0.16469945099473335, -0.13834058648960842, -0.0915672353507071},
{0.0748485168729004, 0.13800603163045752, 0.0892276204482914, 0.03344240394689998, -0.0313300437697022, -0.0703192582493929, -0.09041104436918267, -0.06812480409461773, -0.027530867792536193, 0.03971475578046615, 0.0962875313901042, 0.14814148897477397, 0.16018425905941042, 0.15366147072138003, 0.10584406826305116, 0.061136929890628806},
{0.04132652364211716, 0.07360455803622369, 0.056397006926487823, 0.023936773797439657, -0.011176849602457198, -0.05426031329151281, -0.09132902375612588, -0.12786323836286914, -0.1502238188975248, -0.16614294839397778, -0.1636451397278681, -0.1542279917474148, -0.12771467799883723, -0.10002817046910537, -0.061253544858819654, -0.03242386436364128},
{0.08723948374841772, 0.17393465731009858, 0.16970325764329208, 0.16450380711003673, 0.15581718348542065, 0.14651754489639118, 0.13411200834092032, 0.12166472371231113, 0.10663837445200247, 0.09233422446709097, 0.07607276158693489, 0.061476427428896856, 0.04557690796925883, 0.03250404400373432, 0.018742155087350106, 0.009471466229970906}
};

static const double COARSEST = 1e-8;       /* finest work tolerance that costs hardly anything */
static const double MARGIN = 0.1;          /* work tolerance / tol, below that */
static const double SHARE = 0.03;          /* what sweeps may leave undone / work tolerance */
static const double CUT = 0.1;             /* what the polynomial may cut off / work tolerance */
static const double PACE = 0.3;            /* wanted ratio of a sweep's change to the last one's */
static const double SLOW = 0.8;            /* ratio at which a step is given up */
static const double SHRINK = 0.3, GROW = 3.0;  /* step / step before */

typedef struct {
    lanes c[NC], x[NS], f[NS];             /* constants; states and rates at the nodes */
#if VARYING
    inputs_t in;
    lanes u[NU1], when;
    int terms;
#endif
    double wave[NS][LANES];                /* Chebyshev coefficients of the rates over the step */
    double path[NS][LANES + 1];            /* and of the states */
    double begin[NS], end[NS], scale[NS], past[NS];
    double t, h, from, span;               /* begin, length; where `wave` is left, its length */
    double ratio, left, cut, drift, estimate;
    int64_t next;
} __attribute__((aligned(64))) step_t;

#if VARYING
#define INPUTS(s) ((s)->u)
#else
#define INPUTS(s) NULL
#endif

#if VARYING
/* What holds for the first lane holds for all. */
static void share_inputs(step_t *s)
{
    for (int j = 0; j < NU; ++j)
        for (int m = 0; m <= TERMS; ++m)
            for (int l = 1; l < LANES; ++l)
                s->in.row[j][m][l] = s->in.row[j][m][0];
}
#endif

/* Inputs at times t + h (1 + node) / 2. */
INLINE void set_inputs(step_t *s, double t, double h)
{
#if VARYING
    LANE_LOOP s->when[l] = t + 0.5 * h * (1.0 + NODE[l]);
    inputs_at(&s->in, s->terms, s->when, s->u);
#endif
}

/* ---- one step ----------------------------------------------------------------------------- */

/* Rates at the nodes by the polynomial that is known: that of the step before, continued, or that
 * of a longer attempt at this one. */
static void guess(step_t *s)
{
    lanes z;
    LANE_LOOP z[l] = s->from + s->h / s->span * (1.0 + NODE[l]);
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            double before = 0.0, now = 0.0;
            for (int k = LANES - 1; k > 0; --k) {
                const double next = s->wave[j][k] + 2.0 * z[l] * now - before;
                before = now;
                now = next;
            }
            s->f[j][l] = s->wave[j][0] + z[l] * now - before;
        }
}

/* States at the nodes by integrating the rates; the largest change, relative to the scales. */
static double sweep(step_t *s)
{
    double change = 0.0;
    for (int j = 0; j < ND; ++j) {
        double moved = 0.0, largest = s->scale[j];
#pragma omp simd reduction(max : moved, largest)
        for (int l = 0; l < LANES; ++l) {
            double even = 0.0, odd = 0.0;
            for (int i = 0; i < LANES; i += 2) {
                even += INTEGRAL[i][l] * s->f[j][i];
                odd += INTEGRAL[i + 1][l] * s->f[j][i + 1];
            }
            const double x = s->begin[j] + s->h * (even + odd);
            moved = larger(moved, fabs(x - s->x[j][l]));
            largest = larger(largest, fabs(x));
            s->x[j][l] = x;
        }
        change = larger(change, moved / largest);
    }
    return change;
}

/* Sweep until what is left to change is below the share of the tolerance; false if that takes too
 * long.  A NaN never gets there. */
static int converge(step_t *s, double tol)
{
    double change = INFINITY;
    set_inputs(s, s->t, s->h);
    for (int count = 1; count <= MOST_SWEEPS; ++count) {
        const double now = sweep(s);
        rates(s->c, INPUTS(s), s->x, s->f);
        s->ratio = count > 2 && change > 0.0 ? now / change : 0.0;
        s->left = now * (count > 2 ? smaller(1.0, s->ratio / larger(1.0 - s->ratio, 0.1)) : 1.0);
        if (count > 1 && s->left <= SHARE * tol)
            return 1;
        if (!(now < 1e300) || (count > 4 && s->ratio > SLOW))
            return 0;
        change = now;
    }
    return 0;
}

/* The polynomials of the rates and the states; what their last terms say is cut off. */
static void expand(step_t *s)
{
    s->cut = 0.0;
    for (int j = 0; j < NS; ++j) {
        double *wave = s->wave[j], *path = s->path[j];
        LANE_LOOP {
            double even = 0.0, odd = 0.0;
            for (int i = 0; i < LANES; i += 2) {
                even += SERIES[i][l] * s->f[j][i];
                odd += SERIES[i + 1][l] * s->f[j][i + 1];
            }
            wave[l] = even + odd;
        }
        const double quarter = 0.25 * s->h;
        path[1] = quarter * (2.0 * wave[0] - wave[2]);
        for (int k = 2; k < LANES - 1; ++k)
            path[k] = quarter * (wave[k - 1] - wave[k + 1]) / k;
        path[LANES - 1] = quarter * wave[LANES - 2] / (LANES - 1);
        path[LANES] = quarter * wave[LANES - 1] / LANES;
        double odd = 0.0, even = 0.0;
        for (int k = 1; k < LANES; k += 2)
            odd += path[k], even += path[k + 1];
        path[0] = s->begin[j] + odd - even;
        s->end[j] = s->begin[j] + 2.0 * odd;
        const double top = larger(fabs(wave[LANES - 1]), fabs(wave[LANES - 2]));
        s->cut = larger(s->cut, s->h * top / (LANES * larger(s->scale[j], fabs(s->end[j]))));
    }
    s->from = -1.0;
    s->span = s->h;
}

#if PLANE && !VARYING
#define CHECKED 0
static const double AT_NODES = 0.01;       /* what of the cut is felt at the end of a step */
static const double REST = 1e-9;           /* scales per t_end: slower than that is at rest */

/* Follow the global error along the motion: a local error made at s has grown by about
 * |f(t)| / |f(s)| at t, and has moved a quadrature by f(t) - f(s) in the same proportion.  Steps
 * are good to far less than tol, so that nothing has to be followed across it. */
static void follow_error(step_t *s, double t_end)
{
    double first[NS], last[NS], head = REST / t_end, tail = 0.0;
    for (int j = 0; j < NS; ++j) {
        double even = 0.0, odd = 0.0;
        for (int k = 0; k < LANES; k += 2)
            even += s->wave[j][k], odd += s->wave[j][k + 1];
        first[j] = even - odd;
        last[j] = even + odd;
        if (j < ND) {
            head = larger(head, fabs(first[j]) / s->scale[j]);
            tail = larger(tail, fabs(last[j]) / s->scale[j]);
        }
    }
    const double shift = (s->left + AT_NODES * s->cut) / head;
    s->drift += shift;
    s->estimate = larger(s->estimate, s->drift * tail);
    for (int j = ND; j < NS; ++j) {
        s->past[j] += shift * first[j];
        const double moved = fabs(s->drift * last[j] - s->past[j]);
        s->estimate = larger(s->estimate, moved / s->scale[j]);
    }
}

#else
#define CHECKED 1
/* How far two runs with different tolerances are apart is followed instead, at so many times. */
static void follow_error(step_t *s, double t_end) {}
#endif
enum { CHECKS = 16 };

/* State j at z from -1 to 1 in the step. */
INLINE double state_at(const step_t *s, int j, double z)
{
    double before = 0.0, now = 0.0;
    for (int k = LANES; k > 0; --k) {
        const double next = s->path[j][k] + 2.0 * z * now - before;
        before = now;
        now = next;
    }
    return s->path[j][0] + z * now - before;
}

/* ---- the trajectory ------------------------------------------------------------------------ */

/* Start with constant rates; an explicit Euler probe measures how fast they change. */
static void start(step_t *s, const job_t *job)
{
    const double probe = 1e-4 * job->t_end;
    lanes now[NS];
    double change = 0.0;
#if VARYING
    enter_first(&s->in, 0, job, 0);
    share_inputs(s);
#endif
    memset(s->wave, 0, sizeof s->wave);
    for (int j = 0; j < NS; ++j) {
        s->begin[j] = *job->x0[j];
        s->scale[j] = larger(fabs(s->begin[j]), SCALE_FLOOR);
        s->past[j] = 0.0;
        LANE_LOOP s->x[j][l] = s->begin[j];
    }
    set_inputs(s, 0.0, 0.0);
    rates(s->c, INPUTS(s), s->x, now);
    for (int j = 0; j < NS; ++j) {
        s->wave[j][0] = now[j][0];
        LANE_LOOP s->x[j][l] += probe * now[j][l];
    }
    set_inputs(s, probe, 0.0);
    rates(s->c, INPUTS(s), s->x, s->f);
    for (int j = 0; j < ND; ++j)
        change = larger(change, fabs(s->f[j][0] - now[j][0]) / (fabs(now[j][0]) + SCALE_FLOOR));
    s->h = larger(smaller(probe / (change + DBL_MIN), job->t_end), 1e-6 * job->t_end);
    s->t = s->drift = s->estimate = 0.0;
    s->from = -1.0;
    s->span = s->h;
    s->next = 0;
}

/* States and outputs at the sample times before the end of the step, or to it if it is the last. */
static void sample(step_t *s, const job_t *job, double end)
{
    double at[NS][TILE], y[NY1][TILE], z[TILE];
#if VARYING
    double u[NU1][TILE];
#else
    double (*u)[TILE] = NULL;
#endif
    const double upto = end >= job->t_end ? INFINITY : end;
    while (s->next < job->n_times && job->times[s->next] < upto) {
        int count = 0;
        for (; count < TILE && s->next + count < job->n_times; ++count) {
            if (job->times[s->next + count] >= upto)
                break;
            z[count] = 2.0 * (job->times[s->next + count] - s->t) / s->h - 1.0;
        }
        for (int j = 0; j < NS; ++j) {
#pragma omp simd
            for (int i = 0; i < count; ++i)
                at[j][i] = state_at(s, j, z[i]);
        }
        if (job->observed) {
#if VARYING
            inputs_row(&s->in, s->terms, 0, job->times + s->next, u, count);
#endif
            observe_row(s->c, 0, u, at, y, count);
        }
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + s->next, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
        s->next += count;
    }
}

/* Keep the states at the checks that lie in the step. */
static void keep(const step_t *s, const job_t *job, double end, double (*kept)[NS])
{
    for (int i = 0; i < CHECKS; ++i) {
        const double t = job->t_end * (i + 1.0) / CHECKS, z = 2.0 * (t - s->t) / s->h - 1.0;
        for (int j = 0; t > s->t && t <= end && j < NS; ++j)
            kept[i][j] = state_at(s, j, z);
    }
}

/* Go to the end with sweeps and polynomials good to tau; the status. */
static int travel(step_t *s, const job_t *job, double tau, int64_t *steps, double (*kept)[NS])
{
    start(s, job);
    while (s->t < job->t_end) {
#if VARYING
        const double goal = smaller(job->t_end, s->in.until[0]);
#else
        const double goal = job->t_end;
#endif
        const double rest = goal - s->t, wish = s->h;
        s->h = s->h >= rest ? rest : (s->h + s->h > rest ? 0.5 * rest : s->h);
        if (++*steps >= job->max_steps)
            return STEP_LIMIT;
        guess(s);
        if (!converge(s, tau)) {
            s->h *= 0.5;
            if (s->h < SHORTEST * job->t_end)
                return isfinite(s->left) ? STEP_LIMIT : NON_FINITE;
            continue;
        }
        expand(s);
        const double room = 0.9 * sqrt(sqrt(sqrt(sqrt(CUT * tau / (s->cut + DBL_MIN)))));
        if (room < 0.9) {
            s->h *= larger(room, SHRINK);
            continue;
        }
        for (int j = 0; j < NS; ++j)
            s->scale[j] = larger(s->scale[j], fabs(s->end[j]));
        follow_error(s, job->t_end);
        const double end = s->h >= rest ? goal : s->t + s->h;
        sample(s, job, end);
        if (CHECKED)
            keep(s, job, end, kept);
        memcpy(s->begin, s->end, sizeof s->begin);
        s->t = end;
        s->from = 1.0;
        s->h *= larger(smaller(smaller(room, PACE / (s->ratio + DBL_MIN)), GROW), SHRINK);
#if VARYING
        if (end >= goal) {
            s->h = larger(s->h, wish);         /* what is cut short by a break says little */
            enter(&s->in, 0, job, 0, end);
            share_inputs(s);
        }
#else
        (void)wish;
#endif
    }
    return OK;
}

/* Largest difference of the states kept by two runs, relative to the scales. */
static double apart(const step_t *s, double (*one)[NS], double (*other)[NS])
{
    double most = 0.0;
    for (int i = 0; i < CHECKS; ++i)
        for (int j = 0; j < NS; ++j) {
            const double d = fabs(one[i][j] - other[i][j]) / s->scale[j];
            most = d > most || d != d ? d : most;
        }
    return most;
}

/* Integrate the one trajectory of the job. */
__attribute__((visibility("default"))) void trace(const job_t *job)
{
    step_t s;
    lanes p[NP];
    double kept[2][CHECKS][NS];
    int64_t steps = 0;
    int status = UNSURE;
    for (int j = 0; j < NP; ++j)
        LANE_LOOP p[j][l] = *job->p[j];
    constants(p, s.c);
#if VARYING
    s.terms = most_terms(job);
#endif
    double tau = smaller(MARGIN * job->tol, COARSEST);
    for (int attempt = 0; attempt <= RETRIES; ++attempt) {
        status = travel(&s, job, tau, &steps, kept[attempt % 2]);
        if (status != OK)
            break;
        if (CHECKED)
            s.estimate = attempt ? apart(&s, kept[0], kept[1]) : INFINITY;
        if (s.estimate <= job->tol)
            break;
        status = UNSURE;
        const double finer = CHECKED ? 0.1 : 0.3 * job->tol / s.estimate;
        tau = larger(finer * tau, FINEST);
    }
    for (int j = 0; j < ROWS; ++j)
        for (int64_t i = s.next; job->samples[j] && i < job->n_times; ++i)
            job->samples[j][i] = NAN;
    *job->status = (int8_t)status;
    *job->steps = (int32_t)steps;
    *job->estimate = s.estimate;
}

#endif
