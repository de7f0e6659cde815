/* Generated from derive/ (digest 2782b10879527e9a) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
#undef VARYING
#define VARYING 1

#if DRIVER == 2
enum { LANES = 16 };                    /* moments of a step */
#else
enum { LANES = 8 };                    /* trajectories */
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
enum { NS = 6, ND = 4, S0 = 0, S1 = 1, S2 = 2, S3 = 4, S4 = 5, S5 = 3 };
#endif
enum { NU = 11, NP = 90, NY = 39, NU1 = 11, NY1 = 39, ND1 = ND ? ND : 1 };
enum { NC = VARYING ? 262 : 289 };
#define PLANE 0
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

static void constants(const lanes *p, lanes *c)
{
    LANE_LOOP {
        const double w0 = p[37][l] * p[38][l];
        const double w1 = p[23][l] + 0.1;
        const double w2 = -w1;
        const double w3 = -p[19][l];
        const double w4 = 1.0 + w3;
        const double w5 = p[18][l] * p[18][l];
        const double w6 = w5 + 1e-12;
        const double w7 = sqrt(w6);
        const double w8 = p[17][l] * w7;
        const double w9 = 1.0 / w8;
        const double w10 = w9 * 2.0;
        const double w11 = w4 * p[12][l];
        const double w12 = p[20][l] + w11;
        const double w13 = (-5.0) * p[23][l];
        const double w14 = w13 + 0.5;
        const double w15 = p[24][l] * 0.5;
        const double w16 = p[18][l] * w15;
        const double w17 = p[25][l] * w16;
        const double w18 = -w17;
        const double w19 = p[33][l] + 0.1;
        const double w20 = -w19;
        const double w21 = p[32][l] * p[12][l];
        const double w22 = p[31][l] + w21;
        const double w23 = lane_min(w19, w22);
        const double w24 = lane_max(w20, w23);
        const double w25 = (-5.0) * p[33][l];
        const double w26 = 5.0 * w24;
        const double w27 = -w26;
        const double w28 = w25 + w27;
        const double w29 = w28 + 0.5;
        const double w30 = lane_max(0.0, w29);
        const double w31 = w30 * w30;
        const double w32 = w30 * w31;
        const double w33 = 0.2 * w32;
        const double w34 = 0.5 * w30;
        const double w35 = -w34;
        const double w36 = 1.0 + w35;
        const double w37 = w33 * w36;
        const double w38 = w24 + w37;
        const double w39 = w25 + w26;
        const double w40 = w39 + 0.5;
        const double w41 = lane_max(0.0, w40);
        const double w42 = w41 * w41;
        const double w43 = w41 * w42;
        const double w44 = 0.2 * w43;
        const double w45 = 0.5 * w41;
        const double w46 = -w45;
        const double w47 = 1.0 + w46;
        const double w48 = w44 * w47;
        const double w49 = -w48;
        const double w50 = w38 + w49;
        const double w51 = 0.5 * p[26][l];
        const double w52 = p[18][l] * w51;
        const double w53 = w50 * w52;
        const double w54 = -w53;
        const double w55 = lane_cos(p[12][l]);
        const double w56 = p[36][l] * w55;
        const double w57 = lane_sin(p[12][l]);
        const double w58 = p[41][l] * w57;
        const double w59 = w56 + w58;
        const double w60 = p[39][l] * w55;
        const double w61 = p[40][l] * w57;
        const double w62 = w60 + w61;
        const double w63 = w62 * w17;
        const double w64 = p[30][l] * w52;
        const double w65 = p[28][l] * p[12][l];
        const double w66 = p[27][l] + w65;
        const double w67 = w55 * p[42][l];
        const double w68 = p[11][l] * w55;
        const double w69 = p[15][l] * w57;
        const double w70 = w68 + w69;
        const double w71 = -w59;
        const double w72 = w70 + w71;
        const double w73 = 1.0 / w72;
        const double w74 = w73 * 0.5;
        const double w75 = -w74;
        const double w76 = -p[52][l];
        const double w77 = 1.0 / p[47][l];
        const double w78 = lane_sin(p[13][l]);
        const double w79 = p[14][l] * 0.5;
        const double w80 = lane_cos(p[13][l]);
        const double w81 = w80 * w79;
        const double w82 = p[16][l] * p[16][l];
        const double w83 = w82 * w82;
        const double w84 = -w78;
        const double w85 = w84 * w79;
        const double w86 = (-100000.0) * w77;
        const double w87 = p[49][l] + -1.0;
        const double w88 = lane_max(1e-12, w87);
        const double w89 = sqrt(w88);
        const double w90 = p[48][l] * w89;
        const double w91 = 1.0 / w90;
        const double w92 = -w91;
        const double w93 = 1e-06 * w82;
        const double w94 = -p[49][l];
        const double w95 = 1.0 + w94;
        const double w96 = 1.0 / p[48][l];
        const double w97 = w96 * p[49][l];
        const double w98 = w78 * p[47][l];
        const double w99 = w80 * p[47][l];
        const double w100 = -w99;
        const double w101 = -p[54][l];
        const double w102 = 1.0 / p[53][l];
        const double w103 = -w79;
        const double w104 = w80 * w103;
        const double w105 = w78 * w103;
        const double w106 = (-100000.0) * w102;
        const double w107 = w80 * p[53][l];
        const double w108 = w78 * p[53][l];
        const double w109 = 1.0 / p[61][l];
        const double w110 = p[66][l] * w109;
        const double w111 = -p[56][l];
        const double w112 = 1.0 + w111;
        const double w113 = (-100000.0) * w110;
        const double w114 = p[63][l] + -1.0;
        const double w115 = lane_max(1e-12, w114);
        const double w116 = sqrt(w115);
        const double w117 = p[62][l] * w116;
        const double w118 = 1.0 / w117;
        const double w119 = -w118;
        const double w120 = 1.0 / p[62][l];
        const double w121 = w120 * p[63][l];
        const double w122 = -w114;
        const double w123 = w112 * p[61][l];
        const double w124 = -p[61][l];
        const double w125 = w50 * w50;
        const double w126 = w125 * p[35][l];
        const double w127 = p[34][l] + w126;
        const double w128 = w127 * w52;
        const double w129 = -w128;
        const double w130 = 1.0 / p[38][l];
        const double w131 = w130 * -1.0;
        const double w132 = w130 * w123;
        const double w133 = w130 * w124;
        const double w134 = w130 * w129;
        const double w135 = 0.5 * p[84][l];
        const double w136 = p[81][l] + 0.1;
        const double w137 = -w136;
        const double w138 = p[80][l] * w57;
        const double w139 = p[79][l] * w55;
        const double w140 = -w139;
        const double w141 = w138 + w140;
        const double w142 = -p[67][l];
        const double w143 = -p[83][l];
        const double w144 = (-5.0) * p[81][l];
        const double w145 = w144 + 0.5;
        const double w146 = p[85][l] * w135;
        const double w147 = p[18][l] * w146;
        const double w148 = -w147;
        const double w149 = p[69][l] * p[71][l];
        const double w150 = 0.25 * p[26][l];
        const double w151 = p[18][l] * w150;
        const double w152 = w149 * w151;
        const double w153 = -w107;
        const double w154 = w130 * w148;
        const double w155 = w130 * w152;
        const double w156 = w130 * w52;
        const double w157 = p[71][l] * p[71][l];
        const double w158 = p[77][l] * w157;
        const double w159 = w158 * w151;
        const double w160 = p[71][l] * w52;
        const double w161 = w141 * w147;
        const double w162 = -w161;
        const double w163 = -w70;
        const double w164 = 1.0 / p[89][l];
        const double w165 = w164 * w159;
        const double w166 = w164 * w160;
        const double w167 = w164 * w162;
        const double w168 = w164 * w140;
        const double w169 = w164 * w79;
        const double w170 = w164 * w163;
        const double w171 = w164 * w70;
        const double w172 = w164 * w71;
        const double w173 = w68 + w71;
        const double w174 = w173 + w69;
        const double w175 = 1.0 / w174;
        const double w176 = w175 * 0.5;
        const double w177 = -w176;
        const double w178 = w157 * w151;
        const double w179 = p[74][l] * w178;
        const double w180 = p[77][l] * w178;
        const double w181 = w57 * p[79][l];
        const double w182 = p[79][l] * w147;
        const double w183 = w57 * w182;
        const double w184 = p[80][l] * w147;
        const double w185 = w55 * w184;
        const double w186 = w183 + w185;
        const double w187 = -w186;
        const double w188 = w55 * p[15][l];
        const double w189 = -w188;
        const double w190 = p[11][l] * w57;
        const double w191 = w189 + w190;
        const double w192 = -w190;
        const double w193 = w188 + w192;
        const double w194 = w55 * p[41][l];
        const double w195 = -w194;
        const double w196 = p[36][l] * w57;
        const double w197 = w195 + w196;
        const double w198 = w60 * w17;
        const double w199 = w61 * w17;
        const double w200 = w198 + w199;
        const double w201 = -w200;
        const double w202 = -w64;
        const double w203 = p[15][l] * w55;
        const double w204 = -w203;
        const double w205 = w190 + w204;
        const double w206 = w192 + w203;
        const double w207 = -w67;
        const double w208 = -p[86][l];
        const double w209 = (-0.5) * p[87][l];
        const double w210 = -p[88][l];
        const double w211 = w77 * w77;
        const double w212 = p[46][l] * w74;
        const double w213 = p[47][l] * w212;
        const double w214 = w211 * w213;
        const double w215 = w213 * w77;
        const double w216 = -w215;
        const double w217 = p[44][l] * w74;
        const double w218 = -w217;
        const double w219 = p[48][l] * p[48][l];
        const double w220 = p[49][l] * p[48][l];
        const double w221 = w96 * w220;
        const double w222 = p[50][l] * p[48][l];
        const double w223 = p[51][l] * w222;
        const double w224 = p[51][l] * 0.5;
        const double w225 = -p[51][l];
        const double w226 = -w224;
        const double w227 = -w213;
        const double w228 = -w80;
        const double w229 = w102 * w102;
        const double w230 = p[53][l] * w212;
        const double w231 = w229 * w230;
        const double w232 = w230 * w102;
        const double w233 = -w232;
        const double w234 = -w230;
        const double w235 = w110 * w109;
        const double w236 = p[60][l] * w73;
        const double w237 = p[61][l] * w236;
        const double w238 = w235 * w237;
        const double w239 = -w238;
        const double w240 = (-100000.0) * w238;
        const double w241 = -w240;
        const double w242 = p[58][l] * w73;
        const double w243 = w109 * w109;
        const double w244 = w243 * w237;
        const double w245 = -w244;
        const double w246 = p[62][l] * p[62][l];
        const double w247 = p[63][l] * p[62][l];
        const double w248 = w120 * w247;
        const double w249 = p[64][l] * p[62][l];
        const double w250 = p[65][l] * w249;
        const double w251 = p[65][l] * 0.5;
        const double w252 = -w251;
        const double w253 = -w129;
        const double w254 = w130 * w112;
        const double w255 = w130 * w253;
        const double w256 = w150 * 0.5;
        const double w257 = w149 * p[18][l];
        const double w258 = w52 * p[68][l];
        const double w259 = 5.0 * p[82][l];
        const double w260 = 0.5 * w259;
        const double w261 = 0.2 * w260;
        const double w262 = 2.0 * w259;
        const double w263 = -w261;
        const double w264 = -w263;
        const double w265 = w130 * w257;
        const double w266 = w130 * w258;
        const double w267 = w158 * p[18][l];
        const double w268 = w160 * p[76][l];
        const double w269 = -w141;
        const double w270 = w164 * w267;
        const double w271 = w164 * w268;
        const double w272 = w164 * w269;
        const double w273 = w51 * 2.0;
        const double w274 = p[18][l] * w273;
        const double w275 = p[30][l] * w274;
        const double w276 = w50 * w274;
        const double w277 = w80 * 2.0;
        const double w278 = w78 * 2.0;
        const double w279 = -w278;
        const double w280 = w277 * 0.5;
        const double w281 = -w77;
        const double w282 = w78 * p[51][l];
        const double w283 = -w282;
        const double w284 = w78 * w227;
        const double w285 = w228 * p[47][l];
        const double w286 = w228 * w227;
        const double w287 = -w280;
        const double w288 = w80 * w234;
        const double w289 = w78 * w234;
        const double w290 = -w288;
        const double w291 = -w108;
        const double w292 = -w289;
        const double w293 = w127 * w274;
        const double w294 = w147 * 2.0;
        const double w295 = -w294;
        const double w296 = w59 * w276;
        const double w297 = -w296;
        const double w298 = w80 * p[51][l];
        const double w299 = w278 * 0.5;
        const double w300 = -w299;
        const double w301 = w80 * w227;
        const double w302 = -w98;
        const double w303 = -w284;
        const double w304 = -w301;
        const double w305 = w228 * p[53][l];
        const double w306 = w228 * w234;
        const double w307 = w70 * w276;
        const double w308 = -w307;
        const double w309 = -w112;
        const double w310 = w130 * w98;
        const double w311 = w130 * w284;
        const double w312 = w130 * w285;
        const double w313 = w130 * w286;
        const double w314 = w130 * w153;
        const double w315 = w130 * w290;
        const double w316 = w130 * w291;
        const double w317 = w130 * w292;
        const double w318 = w130 * w274;
        const double w319 = w130 * w295;
        const double w320 = w130 * w302;
        const double w321 = w130 * w303;
        const double w322 = w130 * w100;
        const double w323 = w130 * w304;
        const double w324 = w130 * w108;
        const double w325 = w130 * w289;
        const double w326 = w130 * w305;
        const double w327 = w130 * w306;
        const double w328 = w130 * w309;
        const double w329 = p[82][l] * w141;
        const double w330 = 5.0 * w329;
        const double w331 = 0.5 * w330;
        const double w332 = 0.2 * w331;
        const double w333 = 2.0 * w330;
        const double w334 = -w332;
        const double w335 = -w334;
        const double w336 = w141 * 2.0;
        const double w337 = w147 * w336;
        const double w338 = w269 * w147;
        const double w339 = w269 * w337;
        const double w340 = w78 * w70;
        const double w341 = 0.5 * p[14][l];
        const double w342 = w80 * w341;
        const double w343 = w340 + w342;
        const double w344 = w343 * 2.0;
        const double w345 = w80 * w70;
        const double w346 = w78 * w341;
        const double w347 = -w346;
        const double w348 = w345 + w347;
        const double w349 = w348 * 2.0;
        const double w350 = w348 * p[51][l];
        const double w351 = w344 * 0.5;
        const double w352 = -w351;
        const double w353 = w95 * w77;
        const double w354 = p[48][l] * w77;
        const double w355 = p[49][l] * w354;
        const double w356 = w96 * w355;
        const double w357 = w79 * w98;
        const double w358 = w79 * w100;
        const double w359 = w342 + w340;
        const double w360 = w359 * 2.0;
        const double w361 = -w360;
        const double w362 = w360 * 0.5;
        const double w363 = w95 * w102;
        const double w364 = p[48][l] * w102;
        const double w365 = p[49][l] * w364;
        const double w366 = w96 * w365;
        const double w367 = w79 * w107;
        const double w368 = w79 * w108;
        const double w369 = w163 * w98;
        const double w370 = w358 + w369;
        const double w371 = w163 * w99;
        const double w372 = w357 + w371;
        const double w373 = w70 * w108;
        const double w374 = w367 + w373;
        const double w375 = w70 * w153;
        const double w376 = w368 + w375;
        const double w377 = 2.0 * w59;
        const double w378 = w377 * 0.5;
        const double w379 = -w378;
        const double w380 = p[62][l] * w109;
        const double w381 = p[63][l] * w380;
        const double w382 = w120 * w381;
        const double w383 = w114 * w109;
        const double w384 = -w383;
        const double w385 = w71 * p[61][l];
        const double w386 = w71 * w123;
        const double w387 = w164 * w338;
        const double w388 = w164 * w339;
        const double w389 = w319 + w388;
        const double w390 = w164 * w372;
        const double w391 = w164 * w370;
        const double w392 = w164 * w374;
        const double w393 = w164 * w376;
        const double w394 = w164 * w385;
        const double w395 = w164 * w386;
        const double w396 = -w258;
        const double w397 = p[82][l] * 0.5;
        const double w398 = 5.0 * w397;
        const double w399 = 2.0 * w398;
        const double w400 = 0.5 * w398;
        const double w401 = 0.2 * w400;
        const double w402 = -w401;
        const double w403 = -w397;
        const double w404 = w130 * w396;
        const double w405 = p[71][l] * w274;
        const double w406 = -w268;
        const double w407 = w164 * w405;
        const double w408 = w164 * w406;
        const double w409 = -w293;
        const double w410 = w130 * w409;
        const double w411 = w217 * w77;
        const double w412 = -w411;
        const double w413 = 50.0 * w223;
        const double w414 = 8.0 * w413;
        const double w415 = 2.0 * w413;
        const double w416 = 3.0 * w415;
        const double w417 = -w416;
        const double w418 = -w223;
        const double w419 = w217 * w102;
        const double w420 = -w419;
        const double w421 = w242 * w109;
        const double w422 = p[18][l] * w256;
        const double w423 = w149 * w422;
        const double w424 = w130 * w423;
        const double w425 = w158 * w422;
        const double w426 = w164 * w425;
        c[0][l] = p[12][l];
        c[1][l] = p[21][l];
        c[2][l] = p[22][l];
        c[3][l] = p[29][l];
        c[4][l] = p[43][l];
        c[5][l] = p[44][l];
        c[6][l] = p[45][l];
        c[7][l] = p[46][l];
        c[8][l] = p[47][l];
        c[9][l] = p[48][l];
        c[10][l] = p[50][l];
        c[11][l] = p[51][l];
        c[12][l] = p[52][l];
        c[13][l] = p[53][l];
        c[14][l] = p[54][l];
        c[15][l] = p[55][l];
        c[16][l] = p[57][l];
        c[17][l] = p[58][l];
        c[18][l] = p[59][l];
        c[19][l] = p[60][l];
        c[20][l] = p[61][l];
        c[21][l] = p[62][l];
        c[22][l] = p[64][l];
        c[23][l] = p[65][l];
        c[24][l] = p[68][l];
        c[25][l] = p[70][l];
        c[26][l] = p[72][l];
        c[27][l] = p[73][l];
        c[28][l] = p[75][l];
        c[29][l] = p[76][l];
        c[30][l] = p[78][l];
        c[31][l] = p[82][l];
        c[32][l] = w0;
        c[33][l] = w1;
        c[34][l] = w2;
        c[35][l] = w4;
        c[36][l] = w10;
        c[37][l] = w12;
        c[38][l] = w14;
        c[39][l] = w17;
        c[40][l] = w18;
        c[41][l] = w50;
        c[42][l] = w52;
        c[43][l] = w53;
        c[44][l] = w54;
        c[45][l] = w59;
        c[46][l] = w63;
        c[47][l] = w64;
        c[48][l] = w66;
        c[49][l] = w67;
        c[50][l] = w70;
        c[51][l] = w71;
        c[52][l] = w73;
        c[53][l] = w75;
        c[54][l] = w76;
        c[55][l] = w77;
        c[56][l] = w78;
        c[57][l] = w79;
        c[58][l] = w80;
        c[59][l] = w81;
        c[60][l] = w83;
        c[61][l] = w84;
        c[62][l] = w85;
        c[63][l] = w86;
        c[64][l] = w91;
        c[65][l] = w92;
        c[66][l] = w93;
        c[67][l] = w95;
        c[68][l] = w97;
        c[69][l] = w98;
        c[70][l] = w99;
        c[71][l] = w100;
        c[72][l] = w101;
        c[73][l] = w102;
        c[74][l] = w104;
        c[75][l] = w105;
        c[76][l] = w106;
        c[77][l] = w107;
        c[78][l] = w108;
        c[79][l] = w109;
        c[80][l] = w110;
        c[81][l] = w112;
        c[82][l] = w113;
        c[83][l] = w118;
        c[84][l] = w119;
        c[85][l] = w121;
        c[86][l] = w122;
        c[87][l] = w123;
        c[88][l] = w124;
        c[89][l] = w128;
        c[90][l] = w129;
        c[91][l] = w130;
        c[92][l] = w131;
        c[93][l] = w132;
        c[94][l] = w133;
        c[95][l] = w134;
        c[96][l] = w136;
        c[97][l] = w137;
        c[98][l] = w140;
        c[99][l] = w141;
        c[100][l] = w142;
        c[101][l] = w143;
        c[102][l] = w145;
        c[103][l] = w147;
        c[104][l] = w148;
        c[105][l] = w150;
        c[106][l] = w152;
        c[107][l] = w153;
        c[108][l] = w154;
        c[109][l] = w155;
        c[110][l] = w156;
        c[111][l] = w160;
        c[112][l] = w162;
        c[113][l] = w163;
        c[114][l] = w165;
        c[115][l] = w166;
        c[116][l] = w167;
        c[117][l] = w168;
        c[118][l] = w169;
        c[119][l] = w170;
        c[120][l] = w171;
        c[121][l] = w172;
        c[122][l] = w175;
        c[123][l] = w177;
        c[124][l] = w179;
        c[125][l] = w180;
        c[126][l] = w181;
        c[127][l] = w187;
        c[128][l] = w191;
        c[129][l] = w193;
        c[130][l] = w197;
        c[131][l] = w201;
        c[132][l] = w202;
        c[133][l] = w205;
        c[134][l] = w206;
        c[135][l] = w207;
        c[136][l] = w208;
        c[137][l] = w209;
        c[138][l] = w210;
        c[139][l] = w214;
        c[140][l] = w216;
        c[141][l] = w217;
        c[142][l] = w218;
        c[143][l] = w219;
        c[144][l] = w221;
        c[145][l] = w223;
        c[146][l] = w224;
        c[147][l] = w225;
        c[148][l] = w226;
        c[149][l] = w227;
        c[150][l] = w228;
        c[151][l] = w231;
        c[152][l] = w233;
        c[153][l] = w234;
        c[154][l] = w237;
        c[155][l] = w238;
        c[156][l] = w239;
        c[157][l] = w240;
        c[158][l] = w241;
        c[159][l] = w242;
        c[160][l] = w245;
        c[161][l] = w246;
        c[162][l] = w248;
        c[163][l] = w250;
        c[164][l] = w251;
        c[165][l] = w252;
        c[166][l] = w254;
        c[167][l] = w255;
        c[168][l] = w256;
        c[169][l] = w259;
        c[170][l] = w261;
        c[171][l] = w262;
        c[172][l] = w264;
        c[173][l] = w265;
        c[174][l] = w266;
        c[175][l] = w270;
        c[176][l] = w271;
        c[177][l] = w272;
        c[178][l] = w275;
        c[179][l] = w276;
        c[180][l] = w277;
        c[181][l] = w278;
        c[182][l] = w279;
        c[183][l] = w280;
        c[184][l] = w281;
        c[185][l] = w282;
        c[186][l] = w283;
        c[187][l] = w287;
        c[188][l] = w293;
        c[189][l] = w294;
        c[190][l] = w297;
        c[191][l] = w298;
        c[192][l] = w299;
        c[193][l] = w300;
        c[194][l] = w308;
        c[195][l] = w310;
        c[196][l] = w311;
        c[197][l] = w312;
        c[198][l] = w313;
        c[199][l] = w314;
        c[200][l] = w315;
        c[201][l] = w316;
        c[202][l] = w317;
        c[203][l] = w318;
        c[204][l] = w320;
        c[205][l] = w321;
        c[206][l] = w322;
        c[207][l] = w323;
        c[208][l] = w324;
        c[209][l] = w325;
        c[210][l] = w326;
        c[211][l] = w327;
        c[212][l] = w328;
        c[213][l] = w329;
        c[214][l] = w330;
        c[215][l] = w332;
        c[216][l] = w333;
        c[217][l] = w335;
        c[218][l] = w337;
        c[219][l] = w343;
        c[220][l] = w344;
        c[221][l] = w348;
        c[222][l] = w349;
        c[223][l] = w350;
        c[224][l] = w352;
        c[225][l] = w353;
        c[226][l] = w356;
        c[227][l] = w359;
        c[228][l] = w361;
        c[229][l] = w362;
        c[230][l] = w363;
        c[231][l] = w366;
        c[232][l] = w377;
        c[233][l] = w379;
        c[234][l] = w382;
        c[235][l] = w384;
        c[236][l] = w387;
        c[237][l] = w389;
        c[238][l] = w390;
        c[239][l] = w391;
        c[240][l] = w392;
        c[241][l] = w393;
        c[242][l] = w394;
        c[243][l] = w395;
        c[244][l] = w398;
        c[245][l] = w399;
        c[246][l] = w402;
        c[247][l] = w403;
        c[248][l] = w404;
        c[249][l] = w407;
        c[250][l] = w408;
        c[251][l] = w410;
        c[252][l] = w412;
        c[253][l] = w413;
        c[254][l] = w414;
        c[255][l] = w415;
        c[256][l] = w417;
        c[257][l] = w418;
        c[258][l] = w420;
        c[259][l] = w421;
        c[260][l] = w424;
        c[261][l] = w426;
    }
}

INLINE void rate0(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x2 = MOVE(x, S2);
    const double x5 = MOVE(x, S5);
    const double u0 = u[0][l];
    const double u1 = u[1][l];
    const double u2 = u[2][l];
    const double u3 = u[3][l];
    const double u4 = u[4][l];
    const double u5 = u[5][l];
    const double u6 = u[6][l];
    const double u7 = u[7][l];
    const double u8 = u[8][l];
    const double u9 = u[9][l];
    const double u10 = u[10][l];
    const double w0 = x2 * x1;
    const double w1 = lane_cos(x5);
    const double w2 = u0 * w1;
    const double w3 = lane_sin(x5);
    const double w4 = u1 * w3;
    const double w5 = w2 + w4;
    const double w6 = -w5;
    const double w7 = x0 + w6;
    const double w8 = w7 * w7;
    const double w9 = w8 + 1e-06;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = c[36][l] * u2;
    const double w13 = w12 + w11;
    const double w14 = 1000000.0 * w13;
    const double w15 = lane_min(1.0, w14);
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-8.0) * w16;
    const double w20 = w19 + 6.0;
    const double w21 = 3.0 * w17;
    const double w22 = w20 + w21;
    const double w23 = w18 * w22;
    const double w24 = w13 + (-1e-06);
    const double w25 = lane_max(0.0, w24);
    const double w26 = 1e-06 * w23;
    const double w27 = w26 + 1e-06;
    const double w28 = w27 + w25;
    const double w29 = sqrt(w28);
    const double w30 = c[1][l] * u3;
    const double w31 = w30 + c[37][l];
    const double w32 = w8 + 1e-08;
    const double w33 = u1 * w1;
    const double w34 = u0 * w3;
    const double w35 = -w34;
    const double w36 = w33 + w35;
    const double w37 = -w36;
    const double w38 = x1 + w37;
    const double w39 = w38 * w38;
    const double w40 = w32 + w39;
    const double w41 = w40 * w7;
    const double w42 = sqrt(w32);
    const double w43 = 1.0 / w42;
    const double w44 = w41 * w43;
    const double w45 = c[44][l] * w44;
    const double w46 = w45 + c[32][l];
    const double w47 = c[3][l] * u3;
    const double w48 = w47 + c[48][l];
    const double w49 = w40 * w48;
    const double w50 = c[49][l] * u2;
    const double w51 = c[47][l] * w49;
    const double w52 = w50 + w51;
    const double w53 = c[50][l] * x2;
    const double w54 = x1 + w53;
    const double w55 = c[58][l] * x0;
    const double w56 = c[59][l] * x2;
    const double w57 = w55 + w56;
    const double w58 = c[56][l] * w54;
    const double w59 = w57 + w58;
    const double w60 = w59 * w59;
    const double w61 = c[61][l] * x0;
    const double w62 = c[62][l] * x2;
    const double w63 = w61 + w62;
    const double w64 = c[58][l] * w54;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = w60 + w66;
    const double w68 = w67 * w67;
    const double w69 = w68 + c[60][l];
    const double w70 = sqrt(w69);
    const double w71 = sqrt(w70);
    const double w72 = 1.0 / w71;
    const double w73 = w59 * w72;
    const double w74 = w60 + c[66][l];
    const double w75 = sqrt(w74);
    const double w76 = 1.0 / w75;
    const double w77 = w65 * w76;
    const double w78 = w66 + w74;
    const double w79 = sqrt(w78);
    const double w80 = 1.0 / w70;
    const double w81 = w66 * w80;
    const double w82 = w81 + 5e-13;
    const double w83 = 1.0 / w82;
    const double w84 = 50.0 * u4;
    const double w85 = u4 + (-0.02);
    const double w86 = c[74][l] * x2;
    const double w87 = w55 + w86;
    const double w88 = c[61][l] * w54;
    const double w89 = w87 + w88;
    const double w90 = w89 * w89;
    const double w91 = c[56][l] * x0;
    const double w92 = c[75][l] * x2;
    const double w93 = w91 + w92;
    const double w94 = w93 + w64;
    const double w95 = w94 * w94;
    const double w96 = w90 + w95;
    const double w97 = w96 * w96;
    const double w98 = w97 + c[60][l];
    const double w99 = sqrt(w98);
    const double w100 = sqrt(w99);
    const double w101 = 1.0 / w100;
    const double w102 = w89 * w101;
    const double w103 = w90 + c[66][l];
    const double w104 = sqrt(w103);
    const double w105 = 1.0 / w104;
    const double w106 = w94 * w105;
    const double w107 = w95 + w103;
    const double w108 = sqrt(w107);
    const double w109 = 1.0 / w99;
    const double w110 = w95 * w109;
    const double w111 = w110 + 5e-13;
    const double w112 = 1.0 / w111;
    const double w113 = 50.0 * u5;
    const double w114 = u5 + (-0.02);
    const double w115 = c[15][l] * u6;
    const double w116 = w115 + u7;
    const double w117 = c[81][l] * w116;
    const double w118 = lane_cos(w117);
    const double w119 = x0 * w118;
    const double w120 = c[45][l] * x2;
    const double w121 = x1 + w120;
    const double w122 = lane_sin(w117);
    const double w123 = w121 * w122;
    const double w124 = w119 + w123;
    const double w125 = w124 * w124;
    const double w126 = w121 * w118;
    const double w127 = x0 * w122;
    const double w128 = -w127;
    const double w129 = w126 + w128;
    const double w130 = w129 * w129;
    const double w131 = w125 + w130;
    const double w132 = w131 * w131;
    const double w133 = w132 + c[60][l];
    const double w134 = sqrt(w133);
    const double w135 = sqrt(w134);
    const double w136 = 1.0 / w135;
    const double w137 = w124 * w136;
    const double w138 = w125 + c[66][l];
    const double w139 = sqrt(w138);
    const double w140 = 1.0 / w139;
    const double w141 = w129 * w140;
    const double w142 = w130 + w138;
    const double w143 = sqrt(w142);
    const double w144 = c[91][l] * u2;
    const double w145 = w144 + w0;
    const double w146 = c[95][l] * w44;
    const double w147 = w145 + w146;
    const double w148 = c[99][l] * x2;
    const double w149 = x1 + w148;
    const double w150 = w149 + w37;
    const double w151 = c[100][l] * u6;
    const double w152 = w151 + u8;
    const double w153 = c[101][l] * w152;
    const double w154 = w150 * w150;
    const double w155 = w28 + w154;
    const double w156 = sqrt(w40);
    const double w157 = w156 * x2;
    const double w158 = c[25][l] * w152;
    const double w159 = x2 * x0;
    const double w160 = c[91][l] * u10;
    const double w161 = -w159;
    const double w162 = w160 + w161;
    const double w163 = c[109][l] * w157;
    const double w164 = w162 + w163;
    const double w165 = c[28][l] * u9;
    const double w166 = c[30][l] * w152;
    const double w167 = w165 + w166;
    const double w168 = c[117][l] * u10;
    const double w169 = c[114][l] * w157;
    const double w170 = w168 + w169;
    const double w171 = x0 * w1;
    const double w172 = x1 * w3;
    const double w173 = -w172;
    const double w174 = w171 + w173;
    const double w175 = x0 * w3;
    const double w176 = x1 * w1;
    const double w177 = w175 + w176;
    w[0][l] = w28;
    w[1][l] = w29;
    w[2][l] = w31;
    w[3][l] = w38;
    w[4][l] = w40;
    w[5][l] = w42;
    w[6][l] = w46;
    w[7][l] = w52;
    w[10][l] = w65;
    w[11][l] = w72;
    w[12][l] = w73;
    w[14][l] = w77;
    w[19][l] = w79;
    w[20][l] = w80;
    w[21][l] = w83;
    w[22][l] = w84;
    w[23][l] = w85;
    w[27][l] = w94;
    w[28][l] = w101;
    w[29][l] = w102;
    w[31][l] = w106;
    w[36][l] = w108;
    w[37][l] = w109;
    w[38][l] = w112;
    w[39][l] = w113;
    w[40][l] = w114;
    w[46][l] = w118;
    w[47][l] = w122;
    w[48][l] = w136;
    w[49][l] = w137;
    w[51][l] = w141;
    w[56][l] = w143;
    w[59][l] = w147;
    w[61][l] = w150;
    w[62][l] = w153;
    w[63][l] = w155;
    w[64][l] = w158;
    w[68][l] = w164;
    w[70][l] = w167;
    w[71][l] = w170;
    WRITE(f, S3, w174);
    WRITE(f, S4, w177);
    WRITE(f, S5, x2);
}

INLINE void rate1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double u4 = u[4][l];
    const double u5 = u[5][l];
    const double w0 = lane_atan2(0.0, w[1][l]);
    const double w1 = c[35][l] * w0;
    const double w2 = w[2][l] + w1;
    const double w3 = c[2][l] * w2;
    const double w4 = lane_min(c[33][l], w3);
    const double w5 = lane_max(c[34][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[38][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[38][l];
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 0.2 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-0.2) * w21;
    const double w25 = w23 + w24;
    const double w26 = w25 * w[0][l];
    const double w27 = c[40][l] * w26;
    const double w28 = w[6][l] + w27;
    const double w29 = c[46][l] * w26;
    const double w30 = w[7][l] + w29;
    const double w31 = c[45][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[53][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[7][l] * w34;
    const double w36 = w35 + c[6][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = c[8][l] * w37;
    const double w39 = w38 + c[54][l];
    const double w40 = u4 * w39;
    const double w41 = 1.0 / w37;
    const double w42 = w40 + c[12][l];
    const double w43 = w42 * w41;
    const double w44 = c[55][l] * w43;
    const double w45 = w44 + 5e-06;
    const double w46 = lane_min(w45, w[12][l]);
    const double w47 = -w45;
    const double w48 = lane_max(w47, w46);
    const double w49 = c[63][l] * w43;
    const double w50 = w49 + 0.5;
    const double w51 = (-100000.0) * w48;
    const double w52 = w50 + w51;
    const double w53 = lane_max(0.0, w52);
    const double w54 = w53 * w53;
    const double w55 = w53 * w54;
    const double w56 = (-0.5) * w53;
    const double w57 = w56 + 1.0;
    const double w58 = w55 * w57;
    const double w59 = 100000.0 * w48;
    const double w60 = w50 + w59;
    const double w61 = lane_max(0.0, w60);
    const double w62 = w61 * w61;
    const double w63 = w61 * w62;
    const double w64 = (-0.5) * w61;
    const double w65 = w64 + 1.0;
    const double w66 = w63 * w65;
    const double w67 = 1e-05 * w58;
    const double w68 = w48 + w67;
    const double w69 = (-1e-05) * w66;
    const double w70 = w68 + w69;
    const double w71 = w70 * w70;
    const double w72 = -w71;
    const double w73 = w72 + 1.0;
    const double w74 = sqrt(w73);
    const double w75 = w74 + 5e-06;
    const double w76 = c[5][l] * w34;
    const double w77 = w76 + c[4][l];
    const double w78 = lane_max(0.0, w77);
    const double w79 = w78 * w[14][l];
    const double w80 = w79 * w41;
    const double w81 = c[55][l] * w80;
    const double w82 = lane_min(w81, c[64][l]);
    const double w83 = lane_max(c[65][l], w82);
    const double w84 = c[9][l] * w83;
    const double w85 = c[67][l] * w83;
    const double w86 = -w75;
    const double w87 = (-100000.0) * w74;
    const double w88 = w87 + 0.5;
    const double w89 = w34 * w70;
    const double w90 = w89 * w37;
    const double w91 = c[71][l] * w90;
    const double w92 = c[13][l] * w37;
    const double w93 = w92 + c[72][l];
    const double w94 = u5 * w93;
    const double w95 = w94 + c[14][l];
    const double w96 = w95 * w41;
    const double w97 = c[73][l] * w96;
    const double w98 = w97 + 5e-06;
    const double w99 = lane_min(w98, w[29][l]);
    const double w100 = -w98;
    const double w101 = lane_max(w100, w99);
    const double w102 = c[76][l] * w96;
    const double w103 = w102 + 0.5;
    const double w104 = (-100000.0) * w101;
    const double w105 = w103 + w104;
    const double w106 = lane_max(0.0, w105);
    const double w107 = w106 * w106;
    const double w108 = w106 * w107;
    const double w109 = (-0.5) * w106;
    const double w110 = w109 + 1.0;
    const double w111 = w108 * w110;
    const double w112 = 100000.0 * w101;
    const double w113 = w103 + w112;
    const double w114 = lane_max(0.0, w113);
    const double w115 = w114 * w114;
    const double w116 = w114 * w115;
    const double w117 = (-0.5) * w114;
    const double w118 = w117 + 1.0;
    const double w119 = w116 * w118;
    const double w120 = 1e-05 * w111;
    const double w121 = w101 + w120;
    const double w122 = (-1e-05) * w119;
    const double w123 = w121 + w122;
    const double w124 = w34 * w123;
    const double w125 = w124 * w37;
    const double w126 = w123 * w123;
    const double w127 = -w126;
    const double w128 = w127 + 1.0;
    const double w129 = sqrt(w128);
    const double w130 = w129 + 5e-06;
    const double w131 = w78 * w[31][l];
    const double w132 = w131 * w41;
    const double w133 = c[73][l] * w132;
    const double w134 = lane_min(w133, c[64][l]);
    const double w135 = lane_max(c[65][l], w134);
    const double w136 = c[9][l] * w135;
    const double w137 = c[67][l] * w135;
    const double w138 = -w130;
    const double w139 = (-100000.0) * w129;
    const double w140 = w139 + 0.5;
    const double w141 = c[77][l] * w125;
    const double w142 = c[50][l] * w28;
    const double w143 = w142 + w30;
    const double w144 = c[52][l] * w143;
    const double w145 = lane_max(0.0, w144);
    const double w146 = c[19][l] * w145;
    const double w147 = w146 + c[18][l];
    const double w148 = lane_max(0.001, w147);
    const double w149 = 1.0 / w148;
    const double w150 = c[80][l] * w149;
    const double w151 = w150 + 5e-06;
    const double w152 = lane_min(w151, w[49][l]);
    const double w153 = -w151;
    const double w154 = lane_max(w153, w152);
    const double w155 = c[82][l] * w149;
    const double w156 = w155 + 0.5;
    const double w157 = (-100000.0) * w154;
    const double w158 = w156 + w157;
    const double w159 = lane_max(0.0, w158);
    const double w160 = w159 * w159;
    const double w161 = w159 * w160;
    const double w162 = (-0.5) * w159;
    const double w163 = w162 + 1.0;
    const double w164 = w161 * w163;
    const double w165 = 100000.0 * w154;
    const double w166 = w156 + w165;
    const double w167 = lane_max(0.0, w166);
    const double w168 = w167 * w167;
    const double w169 = w167 * w168;
    const double w170 = (-0.5) * w167;
    const double w171 = w170 + 1.0;
    const double w172 = w169 * w171;
    const double w173 = 1e-05 * w164;
    const double w174 = w154 + w173;
    const double w175 = (-1e-05) * w172;
    const double w176 = w174 + w175;
    const double w177 = w176 * w176;
    const double w178 = -w177;
    const double w179 = w178 + 1.0;
    const double w180 = sqrt(w179);
    const double w181 = w180 + 5e-06;
    const double w182 = c[17][l] * w145;
    const double w183 = w182 + c[16][l];
    const double w184 = lane_max(0.0, w183);
    const double w185 = w184 * w[51][l];
    const double w186 = w185 * w149;
    const double w187 = c[79][l] * w186;
    const double w188 = lane_min(w187, c[83][l]);
    const double w189 = lane_max(c[84][l], w188);
    const double w190 = c[21][l] * w189;
    const double w191 = c[86][l] * w189;
    const double w192 = -w181;
    const double w193 = (-100000.0) * w180;
    const double w194 = w193 + 0.5;
    const double w195 = w145 * w176;
    const double w196 = w195 * w148;
    const double w197 = w196 * w[46][l];
    const double w198 = c[94][l] * w197;
    const double w199 = w[59][l] + w198;
    const double w200 = lane_atan2(w[61][l], w[1][l]);
    const double w201 = w[62][l] + w200;
    const double w202 = c[31][l] * w201;
    const double w203 = lane_min(c[96][l], w202);
    const double w204 = lane_max(c[97][l], w203);
    const double w205 = (-5.0) * w204;
    const double w206 = w205 + c[102][l];
    const double w207 = lane_max(0.0, w206);
    const double w208 = w207 * w207;
    const double w209 = w207 * w208;
    const double w210 = (-0.5) * w207;
    const double w211 = w210 + 1.0;
    const double w212 = w209 * w211;
    const double w213 = 5.0 * w204;
    const double w214 = w213 + c[102][l];
    const double w215 = lane_max(0.0, w214);
    const double w216 = w215 * w215;
    const double w217 = w215 * w216;
    const double w218 = (-0.5) * w215;
    const double w219 = w218 + 1.0;
    const double w220 = w217 * w219;
    const double w221 = 0.2 * w212;
    const double w222 = w204 + w221;
    const double w223 = (-0.2) * w220;
    const double w224 = w222 + w223;
    const double w225 = w224 * w[63][l];
    const double w226 = lane_atan2(w[3][l], w[5][l]);
    const double w227 = c[24][l] * w226;
    const double w228 = w[64][l] + w227;
    const double w229 = w[4][l] * w228;
    const double w230 = c[69][l] * w90;
    const double w231 = c[78][l] * w125;
    const double w232 = w196 * w[47][l];
    const double w233 = c[20][l] * w232;
    const double w234 = c[108][l] * w225;
    const double w235 = w[68][l] + w234;
    const double w236 = c[110][l] * w229;
    const double w237 = w235 + w236;
    const double w238 = c[29][l] * w226;
    const double w239 = w[70][l] + w238;
    const double w240 = w[4][l] * w239;
    const double w241 = c[116][l] * w225;
    const double w242 = w[71][l] + w241;
    const double w243 = c[115][l] * w240;
    const double w244 = w242 + w243;
    w[8][l] = w34;
    w[9][l] = w37;
    w[13][l] = w75;
    w[15][l] = w84;
    w[16][l] = w85;
    w[24][l] = w86;
    w[25][l] = w88;
    w[26][l] = w91;
    w[30][l] = w130;
    w[32][l] = w136;
    w[33][l] = w137;
    w[41][l] = w138;
    w[42][l] = w140;
    w[43][l] = w141;
    w[44][l] = w145;
    w[45][l] = w148;
    w[50][l] = w181;
    w[52][l] = w190;
    w[53][l] = w191;
    w[57][l] = w192;
    w[58][l] = w194;
    w[60][l] = w199;
    w[65][l] = w230;
    w[66][l] = w231;
    w[67][l] = w233;
    w[69][l] = w237;
    w[72][l] = w244;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[15][l]);
    const double w1 = c[68][l] * w0;
    const double w2 = w[16][l] + w1;
    const double w3 = c[9][l] * w2;
    const double w4 = lane_atan(w[32][l]);
    const double w5 = c[68][l] * w4;
    const double w6 = w[33][l] + w5;
    const double w7 = c[9][l] * w6;
    const double w8 = lane_atan(w[52][l]);
    const double w9 = c[85][l] * w8;
    const double w10 = w[53][l] + w9;
    const double w11 = c[21][l] * w10;
    w[17][l] = w3;
    w[34][l] = w7;
    w[54][l] = w11;
}

INLINE void rate3(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[17][l]);
    const double w1 = c[10][l] * w0;
    const double w2 = lane_atan(w[34][l]);
    const double w3 = c[10][l] * w2;
    const double w4 = lane_atan(w[54][l]);
    const double w5 = c[22][l] * w4;
    w[18][l] = w1;
    w[35][l] = w3;
    w[55][l] = w5;
}

INLINE void rate4(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[18][l]);
    const double w1 = w0 * w[19][l];
    const double w2 = w[10][l] * w1;
    const double w3 = w2 * w[20][l];
    const double w4 = c[11][l] * w3;
    const double w5 = w4 + 1e-12;
    const double w6 = w5 * w[21][l];
    const double w7 = (-50.0) * w6;
    const double w8 = w[22][l] + w7;
    const double w9 = lane_min(1.0, w8);
    const double w10 = lane_max(0.0, w9);
    const double w11 = w10 * w10;
    const double w12 = w10 * w11;
    const double w13 = (-8.0) * w10;
    const double w14 = w13 + 6.0;
    const double w15 = 3.0 * w11;
    const double w16 = w14 + w15;
    const double w17 = w12 * w16;
    const double w18 = -w6;
    const double w19 = w[23][l] + w18;
    const double w20 = lane_max(0.0, w19);
    const double w21 = 0.02 * w17;
    const double w22 = w21 + w20;
    const double w23 = w[10][l] * w22;
    const double w24 = w23 * w[11][l];
    const double w25 = w1 * w[11][l];
    const double w26 = c[11][l] * w25;
    const double w27 = w24 + w26;
    const double w28 = lane_min(w27, w[13][l]);
    const double w29 = lane_max(w[24][l], w28);
    const double w30 = (-100000.0) * w29;
    const double w31 = w[25][l] + w30;
    const double w32 = lane_max(0.0, w31);
    const double w33 = w32 * w32;
    const double w34 = w32 * w33;
    const double w35 = (-0.5) * w32;
    const double w36 = w35 + 1.0;
    const double w37 = w34 * w36;
    const double w38 = 100000.0 * w29;
    const double w39 = w[25][l] + w38;
    const double w40 = lane_max(0.0, w39);
    const double w41 = w40 * w40;
    const double w42 = w40 * w41;
    const double w43 = (-0.5) * w40;
    const double w44 = w43 + 1.0;
    const double w45 = w42 * w44;
    const double w46 = 1e-05 * w37;
    const double w47 = w29 + w46;
    const double w48 = (-1e-05) * w45;
    const double w49 = w47 + w48;
    const double w50 = w[8][l] * w49;
    const double w51 = w50 * w[9][l];
    const double w52 = c[69][l] * w51;
    const double w53 = w[26][l] + w52;
    const double w54 = lane_sin(w[35][l]);
    const double w55 = w54 * w[36][l];
    const double w56 = w[27][l] * w55;
    const double w57 = w56 * w[37][l];
    const double w58 = c[11][l] * w57;
    const double w59 = w58 + 1e-12;
    const double w60 = w59 * w[38][l];
    const double w61 = (-50.0) * w60;
    const double w62 = w[39][l] + w61;
    const double w63 = lane_min(1.0, w62);
    const double w64 = lane_max(0.0, w63);
    const double w65 = w64 * w64;
    const double w66 = w64 * w65;
    const double w67 = (-8.0) * w64;
    const double w68 = w67 + 6.0;
    const double w69 = 3.0 * w65;
    const double w70 = w68 + w69;
    const double w71 = w66 * w70;
    const double w72 = -w60;
    const double w73 = w[40][l] + w72;
    const double w74 = lane_max(0.0, w73);
    const double w75 = 0.02 * w71;
    const double w76 = w75 + w74;
    const double w77 = w[27][l] * w76;
    const double w78 = w77 * w[28][l];
    const double w79 = w55 * w[28][l];
    const double w80 = c[11][l] * w79;
    const double w81 = w78 + w80;
    const double w82 = lane_min(w81, w[30][l]);
    const double w83 = lane_max(w[41][l], w82);
    const double w84 = (-100000.0) * w83;
    const double w85 = w[42][l] + w84;
    const double w86 = lane_max(0.0, w85);
    const double w87 = w86 * w86;
    const double w88 = w86 * w87;
    const double w89 = (-0.5) * w86;
    const double w90 = w89 + 1.0;
    const double w91 = w88 * w90;
    const double w92 = 100000.0 * w83;
    const double w93 = w[42][l] + w92;
    const double w94 = lane_max(0.0, w93);
    const double w95 = w94 * w94;
    const double w96 = w94 * w95;
    const double w97 = (-0.5) * w94;
    const double w98 = w97 + 1.0;
    const double w99 = w96 * w98;
    const double w100 = 1e-05 * w91;
    const double w101 = w83 + w100;
    const double w102 = (-1e-05) * w99;
    const double w103 = w101 + w102;
    const double w104 = w[8][l] * w103;
    const double w105 = w104 * w[9][l];
    const double w106 = c[78][l] * w105;
    const double w107 = w[43][l] + w106;
    const double w108 = lane_sin(w[55][l]);
    const double w109 = w108 * w[56][l];
    const double w110 = w109 * w[48][l];
    const double w111 = c[23][l] * w110;
    const double w112 = lane_min(w111, w[50][l]);
    const double w113 = lane_max(w[57][l], w112);
    const double w114 = (-100000.0) * w113;
    const double w115 = w[58][l] + w114;
    const double w116 = lane_max(0.0, w115);
    const double w117 = w116 * w116;
    const double w118 = w116 * w117;
    const double w119 = (-0.5) * w116;
    const double w120 = w119 + 1.0;
    const double w121 = w118 * w120;
    const double w122 = 100000.0 * w113;
    const double w123 = w[58][l] + w122;
    const double w124 = lane_max(0.0, w123);
    const double w125 = w124 * w124;
    const double w126 = w124 * w125;
    const double w127 = (-0.5) * w124;
    const double w128 = w127 + 1.0;
    const double w129 = w126 * w128;
    const double w130 = 1e-05 * w121;
    const double w131 = w113 + w130;
    const double w132 = (-1e-05) * w129;
    const double w133 = w131 + w132;
    const double w134 = w[44][l] * w133;
    const double w135 = w134 * w[45][l];
    const double w136 = w135 * w[47][l];
    const double w137 = c[91][l] * w53;
    const double w138 = w[60][l] + w137;
    const double w139 = c[92][l] * w107;
    const double w140 = w138 + w139;
    const double w141 = c[93][l] * w136;
    const double w142 = w140 + w141;
    const double w143 = c[70][l] * w51;
    const double w144 = w[65][l] + w143;
    const double w145 = c[107][l] * w105;
    const double w146 = w[66][l] + w145;
    const double w147 = w135 * w[46][l];
    const double w148 = c[87][l] * w147;
    const double w149 = w[67][l] + w148;
    const double w150 = c[92][l] * w144;
    const double w151 = w[69][l] + w150;
    const double w152 = c[91][l] * w146;
    const double w153 = w151 + w152;
    const double w154 = c[92][l] * w149;
    const double w155 = w153 + w154;
    const double w156 = c[118][l] * w53;
    const double w157 = w[72][l] + w156;
    const double w158 = c[118][l] * w107;
    const double w159 = w157 + w158;
    const double w160 = c[119][l] * w144;
    const double w161 = w159 + w160;
    const double w162 = c[120][l] * w146;
    const double w163 = w161 + w162;
    const double w164 = c[121][l] * w149;
    const double w165 = w163 + w164;
    WRITE(f, S0, w142);
    WRITE(f, S1, w155);
    WRITE(f, S2, w165);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[73];
    LANE_LOOP rate0(c, u, x, f, w, l);
    LANE_LOOP rate1(c, u, x, f, w, l);
    LANE_LOOP rate2(c, u, x, f, w, l);
    LANE_LOOP rate3(c, u, x, f, w, l);
    LANE_LOOP rate4(c, u, x, f, w, l);
}

#if DRIVER == 1
INLINE void entry0(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1], lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x2 = MOVE(x, S2);
    const double x5 = MOVE(x, S5);
    const double u0 = u[0][l];
    const double u1 = u[1][l];
    const double u2 = u[2][l];
    const double u3 = u[3][l];
    const double u4 = u[4][l];
    const double u5 = u[5][l];
    const double u6 = u[6][l];
    const double u7 = u[7][l];
    const double u8 = u[8][l];
    const double u9 = u[9][l];
    const double u10 = u[10][l];
    const double w0 = x2 * x1;
    const double w1 = lane_cos(x5);
    const double w2 = u0 * w1;
    const double w3 = lane_sin(x5);
    const double w4 = u1 * w3;
    const double w5 = w2 + w4;
    const double w6 = -w5;
    const double w7 = x0 + w6;
    const double w8 = w7 * w7;
    const double w9 = w8 + 1e-06;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = c[36][l] * u2;
    const double w13 = w12 + w11;
    const double w14 = 1000000.0 * w13;
    const double w15 = lane_min(1.0, w14);
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-8.0) * w16;
    const double w20 = w19 + 6.0;
    const double w21 = 3.0 * w17;
    const double w22 = w20 + w21;
    const double w23 = w18 * w22;
    const double w24 = w13 + (-1e-06);
    const double w25 = lane_max(0.0, w24);
    const double w26 = 1e-06 * w23;
    const double w27 = w26 + 1e-06;
    const double w28 = w27 + w25;
    const double w29 = sqrt(w28);
    const double w30 = c[1][l] * u3;
    const double w31 = w30 + c[37][l];
    const double w32 = w8 + 1e-08;
    const double w33 = u1 * w1;
    const double w34 = u0 * w3;
    const double w35 = -w34;
    const double w36 = w33 + w35;
    const double w37 = -w36;
    const double w38 = x1 + w37;
    const double w39 = w38 * w38;
    const double w40 = w32 + w39;
    const double w41 = w40 * w7;
    const double w42 = sqrt(w32);
    const double w43 = 1.0 / w42;
    const double w44 = w41 * w43;
    const double w45 = c[44][l] * w44;
    const double w46 = w45 + c[32][l];
    const double w47 = c[3][l] * u3;
    const double w48 = w47 + c[48][l];
    const double w49 = w40 * w48;
    const double w50 = c[49][l] * u2;
    const double w51 = c[47][l] * w49;
    const double w52 = w50 + w51;
    const double w53 = c[50][l] * x2;
    const double w54 = x1 + w53;
    const double w55 = c[58][l] * x0;
    const double w56 = c[59][l] * x2;
    const double w57 = w55 + w56;
    const double w58 = c[56][l] * w54;
    const double w59 = w57 + w58;
    const double w60 = w59 * w59;
    const double w61 = c[61][l] * x0;
    const double w62 = c[62][l] * x2;
    const double w63 = w61 + w62;
    const double w64 = c[58][l] * w54;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = w60 + w66;
    const double w68 = w67 * w67;
    const double w69 = w68 + c[60][l];
    const double w70 = sqrt(w69);
    const double w71 = sqrt(w70);
    const double w72 = 1.0 / w71;
    const double w73 = w59 * w72;
    const double w74 = w60 + c[66][l];
    const double w75 = sqrt(w74);
    const double w76 = 1.0 / w75;
    const double w77 = w65 * w76;
    const double w78 = w66 + w74;
    const double w79 = sqrt(w78);
    const double w80 = 1.0 / w70;
    const double w81 = w66 * w80;
    const double w82 = w81 + 5e-13;
    const double w83 = 1.0 / w82;
    const double w84 = 50.0 * u4;
    const double w85 = u4 + (-0.02);
    const double w86 = c[74][l] * x2;
    const double w87 = w55 + w86;
    const double w88 = c[61][l] * w54;
    const double w89 = w87 + w88;
    const double w90 = w89 * w89;
    const double w91 = c[56][l] * x0;
    const double w92 = c[75][l] * x2;
    const double w93 = w91 + w92;
    const double w94 = w93 + w64;
    const double w95 = w94 * w94;
    const double w96 = w90 + w95;
    const double w97 = w96 * w96;
    const double w98 = w97 + c[60][l];
    const double w99 = sqrt(w98);
    const double w100 = sqrt(w99);
    const double w101 = 1.0 / w100;
    const double w102 = w89 * w101;
    const double w103 = w90 + c[66][l];
    const double w104 = sqrt(w103);
    const double w105 = 1.0 / w104;
    const double w106 = w94 * w105;
    const double w107 = w95 + w103;
    const double w108 = sqrt(w107);
    const double w109 = 1.0 / w99;
    const double w110 = w95 * w109;
    const double w111 = w110 + 5e-13;
    const double w112 = 1.0 / w111;
    const double w113 = 50.0 * u5;
    const double w114 = u5 + (-0.02);
    const double w115 = c[15][l] * u6;
    const double w116 = w115 + u7;
    const double w117 = c[81][l] * w116;
    const double w118 = lane_cos(w117);
    const double w119 = x0 * w118;
    const double w120 = c[45][l] * x2;
    const double w121 = x1 + w120;
    const double w122 = lane_sin(w117);
    const double w123 = w121 * w122;
    const double w124 = w119 + w123;
    const double w125 = w124 * w124;
    const double w126 = w121 * w118;
    const double w127 = x0 * w122;
    const double w128 = -w127;
    const double w129 = w126 + w128;
    const double w130 = w129 * w129;
    const double w131 = w125 + w130;
    const double w132 = w131 * w131;
    const double w133 = w132 + c[60][l];
    const double w134 = sqrt(w133);
    const double w135 = sqrt(w134);
    const double w136 = 1.0 / w135;
    const double w137 = w124 * w136;
    const double w138 = w125 + c[66][l];
    const double w139 = sqrt(w138);
    const double w140 = 1.0 / w139;
    const double w141 = w129 * w140;
    const double w142 = w130 + w138;
    const double w143 = sqrt(w142);
    const double w144 = c[91][l] * u2;
    const double w145 = w144 + w0;
    const double w146 = c[95][l] * w44;
    const double w147 = w145 + w146;
    const double w148 = c[99][l] * x2;
    const double w149 = x1 + w148;
    const double w150 = w149 + w37;
    const double w151 = c[100][l] * u6;
    const double w152 = w151 + u8;
    const double w153 = c[101][l] * w152;
    const double w154 = w150 * w150;
    const double w155 = w28 + w154;
    const double w156 = sqrt(w40);
    const double w157 = w156 * x2;
    const double w158 = c[25][l] * w152;
    const double w159 = x2 * x0;
    const double w160 = c[91][l] * u10;
    const double w161 = -w159;
    const double w162 = w160 + w161;
    const double w163 = c[109][l] * w157;
    const double w164 = w162 + w163;
    const double w165 = c[28][l] * u9;
    const double w166 = c[30][l] * w152;
    const double w167 = w165 + w166;
    const double w168 = c[117][l] * u10;
    const double w169 = c[114][l] * w157;
    const double w170 = w168 + w169;
    const double w171 = x0 * w1;
    const double w172 = x1 * w3;
    const double w173 = -w172;
    const double w174 = w171 + w173;
    const double w175 = x0 * w3;
    const double w176 = x1 * w1;
    const double w177 = w175 + w176;
    const double w178 = c[43][l] * w40;
    const double w179 = c[89][l] * w40;
    const double w180 = 0.0 <= w15 ? 1.0 : 0.0;
    const double w181 = w15 <= 0.0 ? 1.0 : 0.0;
    const double w182 = w180 + w181;
    const double w183 = 1.0 / w182;
    const double w184 = w180 * w183;
    const double w185 = w14 <= 1.0 ? 1.0 : 0.0;
    const double w186 = 1.0 <= w14 ? 1.0 : 0.0;
    const double w187 = w185 + w186;
    const double w188 = 1.0 / w187;
    const double w189 = w185 * w188;
    const double w190 = 1.0 / w10;
    const double w191 = 0.0 <= w24 ? 1.0 : 0.0;
    const double w192 = w24 <= 0.0 ? 1.0 : 0.0;
    const double w193 = w191 + w192;
    const double w194 = 1.0 / w193;
    const double w195 = w191 * w194;
    const double w196 = w44 * w43;
    const double w197 = w73 * w72;
    const double w198 = w77 * w76;
    const double w199 = 1.0 / w79;
    const double w200 = w81 * w80;
    const double w201 = w102 * w101;
    const double w202 = w106 * w105;
    const double w203 = 1.0 / w108;
    const double w204 = w110 * w109;
    const double w205 = w137 * w136;
    const double w206 = 1.0 / w134;
    const double w207 = w141 * w140;
    const double w208 = 1.0 / w143;
    const double w209 = 1.0 / w156;
    const double w210 = 1.0 / w40;
    const double w211 = w42 * w210;
    const double w212 = w38 * w210;
    const double w213 = 1.0 / w155;
    const double w214 = w29 * w213;
    const double w215 = w150 * w213;
    const double w216 = 1.0 / w29;
    const double w217 = w7 * w190;
    const double w218 = w7 * w217;
    const double w219 = w10 + w218;
    const double w220 = w189 * w219;
    const double w221 = w184 * w220;
    const double w222 = w17 * w221;
    const double w223 = w16 * w221;
    const double w224 = w16 * w223;
    const double w225 = 1000000.0 * w222;
    const double w226 = 2000000.0 * w224;
    const double w227 = w225 + w226;
    const double w228 = w22 * w227;
    const double w229 = (-8000000.0) * w221;
    const double w230 = 6000000.0 * w223;
    const double w231 = w229 + w230;
    const double w232 = w18 * w231;
    const double w233 = w195 * w219;
    const double w234 = 1e-06 * w228;
    const double w235 = 1e-06 * w232;
    const double w236 = w234 + w235;
    const double w237 = w236 + w233;
    const double w238 = w48 * w7;
    const double w239 = c[178][l] * w238;
    const double w240 = c[179][l] * w8;
    const double w241 = w240 + w178;
    const double w242 = w241 * w43;
    const double w243 = w7 * w43;
    const double w244 = w196 * w243;
    const double w245 = c[44][l] * w244;
    const double w246 = w242 + w245;
    const double w247 = c[180][l] * w59;
    const double w248 = c[182][l] * w65;
    const double w249 = w247 + w248;
    const double w250 = w67 * w249;
    const double w251 = w250 * w80;
    const double w252 = w251 * w72;
    const double w253 = w197 * w252;
    const double w254 = c[58][l] * w72;
    const double w255 = (-0.5) * w253;
    const double w256 = w254 + w255;
    const double w257 = w59 * w76;
    const double w258 = w198 * w257;
    const double w259 = c[56][l] * w76;
    const double w260 = c[183][l] * w258;
    const double w261 = w259 + w260;
    const double w262 = w249 * w199;
    const double w263 = w65 * w80;
    const double w264 = w200 * w251;
    const double w265 = c[181][l] * w263;
    const double w266 = w265 + w264;
    const double w267 = c[180][l] * w89;
    const double w268 = c[181][l] * w94;
    const double w269 = w267 + w268;
    const double w270 = w96 * w269;
    const double w271 = w270 * w109;
    const double w272 = w271 * w101;
    const double w273 = w201 * w272;
    const double w274 = c[58][l] * w101;
    const double w275 = (-0.5) * w273;
    const double w276 = w274 + w275;
    const double w277 = w89 * w105;
    const double w278 = w202 * w277;
    const double w279 = c[56][l] * w105;
    const double w280 = c[187][l] * w278;
    const double w281 = w279 + w280;
    const double w282 = w269 * w203;
    const double w283 = w94 * w109;
    const double w284 = w204 * w271;
    const double w285 = c[181][l] * w283;
    const double w286 = -w284;
    const double w287 = w285 + w286;
    const double w288 = w118 * w136;
    const double w289 = w124 * w118;
    const double w290 = w129 * w122;
    const double w291 = 2.0 * w289;
    const double w292 = (-2.0) * w290;
    const double w293 = w291 + w292;
    const double w294 = w131 * w293;
    const double w295 = w294 * w206;
    const double w296 = w295 * w136;
    const double w297 = w205 * w296;
    const double w298 = (-0.5) * w297;
    const double w299 = w288 + w298;
    const double w300 = w122 * w140;
    const double w301 = w289 * w140;
    const double w302 = w207 * w301;
    const double w303 = w300 + w302;
    const double w304 = w293 * w208;
    const double w305 = c[188][l] * w8;
    const double w306 = w305 + w179;
    const double w307 = w306 * w43;
    const double w308 = w38 * w209;
    const double w309 = x2 * w308;
    const double w310 = w40 * w211;
    const double w311 = w48 * w38;
    const double w312 = w7 * w38;
    const double w313 = w312 * w43;
    const double w314 = c[178][l] * w311;
    const double w315 = c[190][l] * w313;
    const double w316 = w314 + w315;
    const double w317 = c[181][l] * w59;
    const double w318 = c[180][l] * w65;
    const double w319 = w317 + w318;
    const double w320 = w67 * w319;
    const double w321 = w320 * w80;
    const double w322 = w321 * w72;
    const double w323 = w197 * w322;
    const double w324 = c[56][l] * w72;
    const double w325 = (-0.5) * w323;
    const double w326 = w324 + w325;
    const double w327 = c[58][l] * w76;
    const double w328 = c[193][l] * w258;
    const double w329 = w327 + w328;
    const double w330 = w319 * w199;
    const double w331 = w200 * w321;
    const double w332 = c[180][l] * w263;
    const double w333 = -w331;
    const double w334 = w332 + w333;
    const double w335 = c[182][l] * w89;
    const double w336 = c[180][l] * w94;
    const double w337 = w335 + w336;
    const double w338 = w96 * w337;
    const double w339 = w338 * w109;
    const double w340 = w339 * w101;
    const double w341 = w201 * w340;
    const double w342 = c[56][l] * w101;
    const double w343 = 0.5 * w341;
    const double w344 = w342 + w343;
    const double w345 = c[58][l] * w105;
    const double w346 = c[192][l] * w278;
    const double w347 = w345 + w346;
    const double w348 = w337 * w203;
    const double w349 = w204 * w339;
    const double w350 = c[180][l] * w283;
    const double w351 = -w349;
    const double w352 = w350 + w351;
    const double w353 = c[194][l] * w313;
    const double w354 = w314 + w353;
    const double w355 = w122 * w136;
    const double w356 = w124 * w122;
    const double w357 = w129 * w118;
    const double w358 = 2.0 * w356;
    const double w359 = 2.0 * w357;
    const double w360 = w358 + w359;
    const double w361 = w131 * w360;
    const double w362 = w361 * w206;
    const double w363 = w362 * w136;
    const double w364 = w205 * w363;
    const double w365 = (-0.5) * w364;
    const double w366 = w355 + w365;
    const double w367 = w118 * w140;
    const double w368 = w356 * w140;
    const double w369 = w207 * w368;
    const double w370 = -w369;
    const double w371 = w367 + w370;
    const double w372 = w360 * w208;
    const double w373 = c[220][l] * w59;
    const double w374 = c[222][l] * w65;
    const double w375 = w373 + w374;
    const double w376 = w67 * w375;
    const double w377 = w376 * w80;
    const double w378 = w377 * w72;
    const double w379 = w197 * w378;
    const double w380 = c[219][l] * w72;
    const double w381 = (-0.5) * w379;
    const double w382 = w380 + w381;
    const double w383 = c[221][l] * w76;
    const double w384 = c[224][l] * w258;
    const double w385 = w383 + w384;
    const double w386 = w375 * w199;
    const double w387 = w200 * w377;
    const double w388 = c[222][l] * w263;
    const double w389 = -w387;
    const double w390 = w388 + w389;
    const double w391 = c[228][l] * w89;
    const double w392 = c[222][l] * w94;
    const double w393 = w391 + w392;
    const double w394 = w96 * w393;
    const double w395 = w394 * w109;
    const double w396 = w395 * w101;
    const double w397 = w201 * w396;
    const double w398 = c[227][l] * w101;
    const double w399 = 0.5 * w397;
    const double w400 = w398 + w399;
    const double w401 = c[221][l] * w105;
    const double w402 = c[229][l] * w278;
    const double w403 = w401 + w402;
    const double w404 = w393 * w203;
    const double w405 = w204 * w395;
    const double w406 = c[222][l] * w283;
    const double w407 = -w405;
    const double w408 = w406 + w407;
    const double w409 = c[232][l] * w356;
    const double w410 = c[232][l] * w357;
    const double w411 = w409 + w410;
    const double w412 = w131 * w411;
    const double w413 = w412 * w206;
    const double w414 = w413 * w136;
    const double w415 = w205 * w414;
    const double w416 = c[45][l] * w355;
    const double w417 = (-0.5) * w415;
    const double w418 = w416 + w417;
    const double w419 = c[45][l] * w367;
    const double w420 = c[233][l] * w369;
    const double w421 = w419 + w420;
    const double w422 = w411 * w208;
    const double w423 = c[114][l] * w156;
    const double w424 = c[167][l] * w244;
    const double w425 = c[92][l] * w307;
    const double w426 = c[109][l] * w309;
    const double w427 = c[174][l] * w310;
    const double w428 = w424 + w425;
    const double w429 = w7 * w209;
    const double w430 = x2 * w429;
    const double w431 = w212 * w243;
    const double w432 = w40 * w431;
    const double w433 = w237 * w216;
    const double w434 = w215 * w433;
    const double w435 = -x2;
    const double w436 = c[109][l] * w430;
    const double w437 = w435 + w436;
    const double w438 = c[248][l] * w432;
    const double w439 = w437 + w438;
    const double w440 = c[114][l] * w430;
    const double w441 = c[250][l] * w432;
    const double w442 = w440 + w441;
    const double w443 = c[251][l] * w313;
    const double w444 = x2 + w443;
    const double w445 = w426 + w427;
    const double w446 = c[114][l] * w309;
    const double w447 = c[176][l] * w310;
    const double w448 = w446 + w447;
    const double w449 = -w3;
    const double w450 = -x0;
    const double w451 = c[109][l] * w156;
    const double w452 = w450 + w451;
    const double w453 = w10 * w36;
    const double w454 = w7 * w36;
    const double w455 = w454 * w190;
    const double w456 = w7 * w455;
    const double w457 = w453 + w456;
    const double w458 = w189 * w457;
    const double w459 = w184 * w458;
    const double w460 = w16 * w459;
    const double w461 = 8000000.0 * w459;
    const double w462 = (-6000000.0) * w460;
    const double w463 = w461 + w462;
    const double w464 = w18 * w463;
    const double w465 = w17 * w459;
    const double w466 = w16 * w460;
    const double w467 = 1000000.0 * w465;
    const double w468 = 2000000.0 * w466;
    const double w469 = w467 + w468;
    const double w470 = w22 * w469;
    const double w471 = w195 * w457;
    const double w472 = 1e-06 * w464;
    const double w473 = (-1e-06) * w470;
    const double w474 = w472 + w473;
    const double w475 = -w471;
    const double w476 = w474 + w475;
    const double w477 = w38 * w5;
    const double w478 = (-2.0) * w454;
    const double w479 = 2.0 * w477;
    const double w480 = w478 + w479;
    const double w481 = w48 * w480;
    const double w482 = c[47][l] * w481;
    const double w483 = w7 * w480;
    const double w484 = w40 * w36;
    const double w485 = c[43][l] * w483;
    const double w486 = c[44][l] * w484;
    const double w487 = w485 + w486;
    const double w488 = w487 * w43;
    const double w489 = w454 * w43;
    const double w490 = w196 * w489;
    const double w491 = c[43][l] * w490;
    const double w492 = w488 + w491;
    const double w493 = c[89][l] * w483;
    const double w494 = c[90][l] * w484;
    const double w495 = w493 + w494;
    const double w496 = w495 * w43;
    const double w497 = c[95][l] * w490;
    const double w498 = c[92][l] * w496;
    const double w499 = w497 + w498;
    const double w500 = w480 * w209;
    const double w501 = x2 * w500;
    const double w502 = w211 * w5;
    const double w503 = w212 * w489;
    const double w504 = w502 + w503;
    const double w505 = w40 * w504;
    const double w506 = w214 * w5;
    const double w507 = w476 * w216;
    const double w508 = w215 * w507;
    const double w509 = (-0.5) * w508;
    const double w510 = w506 + w509;
    const double w511 = w150 * w5;
    const double w512 = 2.0 * w511;
    const double w513 = w476 + w512;
    const double w514 = c[260][l] * w501;
    const double w515 = c[174][l] * w505;
    const double w516 = w514 + w515;
    const double w517 = c[261][l] * w501;
    const double w518 = c[176][l] * w505;
    const double w519 = w517 + w518;
    const double w520 = -w175;
    const double w521 = -w176;
    const double w522 = w520 + w521;
    w[0][l] = w7;
    w[1][l] = w28;
    w[2][l] = w29;
    w[3][l] = w31;
    w[4][l] = w38;
    w[5][l] = w40;
    w[6][l] = w42;
    w[7][l] = w46;
    w[8][l] = w52;
    w[11][l] = w65;
    w[12][l] = w72;
    w[13][l] = w73;
    w[15][l] = w77;
    w[20][l] = w79;
    w[21][l] = w80;
    w[22][l] = w83;
    w[23][l] = w84;
    w[24][l] = w85;
    w[28][l] = w94;
    w[29][l] = w101;
    w[30][l] = w102;
    w[32][l] = w106;
    w[37][l] = w108;
    w[38][l] = w109;
    w[39][l] = w112;
    w[40][l] = w113;
    w[41][l] = w114;
    w[47][l] = w118;
    w[48][l] = w122;
    w[49][l] = w136;
    w[50][l] = w137;
    w[52][l] = w141;
    w[57][l] = w143;
    w[60][l] = w147;
    w[62][l] = w150;
    w[63][l] = w153;
    w[64][l] = w155;
    w[65][l] = w158;
    w[69][l] = w164;
    w[71][l] = w167;
    w[72][l] = w170;
    w[74][l] = w214;
    w[75][l] = w237;
    w[76][l] = w239;
    w[77][l] = w246;
    w[80][l] = w251;
    w[81][l] = w252;
    w[82][l] = w256;
    w[84][l] = w261;
    w[87][l] = w262;
    w[88][l] = w266;
    w[91][l] = w271;
    w[92][l] = w272;
    w[93][l] = w276;
    w[95][l] = w281;
    w[98][l] = w282;
    w[99][l] = w287;
    w[104][l] = w296;
    w[105][l] = w299;
    w[107][l] = w303;
    w[110][l] = w304;
    w[113][l] = w316;
    w[116][l] = w321;
    w[117][l] = w322;
    w[118][l] = w326;
    w[120][l] = w329;
    w[123][l] = w330;
    w[124][l] = w334;
    w[127][l] = w339;
    w[128][l] = w340;
    w[129][l] = w344;
    w[131][l] = w347;
    w[134][l] = w348;
    w[135][l] = w352;
    w[138][l] = w354;
    w[141][l] = w363;
    w[142][l] = w366;
    w[145][l] = w371;
    w[148][l] = w372;
    w[151][l] = w377;
    w[152][l] = w378;
    w[153][l] = w382;
    w[155][l] = w385;
    w[158][l] = w386;
    w[159][l] = w390;
    w[162][l] = w395;
    w[163][l] = w396;
    w[164][l] = w400;
    w[166][l] = w403;
    w[169][l] = w404;
    w[170][l] = w408;
    w[173][l] = w414;
    w[174][l] = w418;
    w[176][l] = w421;
    w[179][l] = w422;
    w[182][l] = w423;
    w[185][l] = w428;
    w[187][l] = w434;
    w[191][l] = w439;
    w[193][l] = w442;
    w[197][l] = w444;
    w[201][l] = w445;
    w[203][l] = w448;
    w[211][l] = w452;
    w[214][l] = w476;
    w[215][l] = w480;
    w[216][l] = w482;
    w[217][l] = w492;
    w[239][l] = w499;
    w[241][l] = w510;
    w[242][l] = w513;
    w[246][l] = w516;
    w[248][l] = w519;
    WRITE(f, S3, w174);
    WRITE(f, S4, w177);
    WRITE(f, S5, x2);
    WRITE_ENTRY(J, S3, S0, w1);
    WRITE_ENTRY(J, S4, S0, w3);
    WRITE_ENTRY(J, S3, S1, w449);
    WRITE_ENTRY(J, S4, S1, w1);
    WRITE_ENTRY(J, S5, S2, 1.0);
    WRITE_ENTRY(J, S3, S5, w522);
    WRITE_ENTRY(J, S4, S5, w174);
}

INLINE void entry1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1], lanes *w, int l)
{
    const double x1 = MOVE(x, S1);
    const double u4 = u[4][l];
    const double u5 = u[5][l];
    const double w0 = lane_atan2(0.0, w[2][l]);
    const double w1 = c[35][l] * w0;
    const double w2 = w[3][l] + w1;
    const double w3 = c[2][l] * w2;
    const double w4 = lane_min(c[33][l], w3);
    const double w5 = lane_max(c[34][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[38][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[38][l];
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 0.2 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-0.2) * w21;
    const double w25 = w23 + w24;
    const double w26 = w25 * w[1][l];
    const double w27 = c[40][l] * w26;
    const double w28 = w[7][l] + w27;
    const double w29 = c[46][l] * w26;
    const double w30 = w[8][l] + w29;
    const double w31 = c[45][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[53][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[7][l] * w34;
    const double w36 = w35 + c[6][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = c[8][l] * w37;
    const double w39 = w38 + c[54][l];
    const double w40 = u4 * w39;
    const double w41 = 1.0 / w37;
    const double w42 = w40 + c[12][l];
    const double w43 = w42 * w41;
    const double w44 = c[55][l] * w43;
    const double w45 = w44 + 5e-06;
    const double w46 = lane_min(w45, w[13][l]);
    const double w47 = -w45;
    const double w48 = lane_max(w47, w46);
    const double w49 = c[63][l] * w43;
    const double w50 = w49 + 0.5;
    const double w51 = (-100000.0) * w48;
    const double w52 = w50 + w51;
    const double w53 = lane_max(0.0, w52);
    const double w54 = w53 * w53;
    const double w55 = w53 * w54;
    const double w56 = (-0.5) * w53;
    const double w57 = w56 + 1.0;
    const double w58 = w55 * w57;
    const double w59 = 100000.0 * w48;
    const double w60 = w50 + w59;
    const double w61 = lane_max(0.0, w60);
    const double w62 = w61 * w61;
    const double w63 = w61 * w62;
    const double w64 = (-0.5) * w61;
    const double w65 = w64 + 1.0;
    const double w66 = w63 * w65;
    const double w67 = 1e-05 * w58;
    const double w68 = w48 + w67;
    const double w69 = (-1e-05) * w66;
    const double w70 = w68 + w69;
    const double w71 = w70 * w70;
    const double w72 = -w71;
    const double w73 = w72 + 1.0;
    const double w74 = sqrt(w73);
    const double w75 = w74 + 5e-06;
    const double w76 = c[5][l] * w34;
    const double w77 = w76 + c[4][l];
    const double w78 = lane_max(0.0, w77);
    const double w79 = w78 * w[15][l];
    const double w80 = w79 * w41;
    const double w81 = c[55][l] * w80;
    const double w82 = lane_min(w81, c[64][l]);
    const double w83 = lane_max(c[65][l], w82);
    const double w84 = c[9][l] * w83;
    const double w85 = c[67][l] * w83;
    const double w86 = -w75;
    const double w87 = (-100000.0) * w74;
    const double w88 = w87 + 0.5;
    const double w89 = w34 * w70;
    const double w90 = w89 * w37;
    const double w91 = c[71][l] * w90;
    const double w92 = c[13][l] * w37;
    const double w93 = w92 + c[72][l];
    const double w94 = u5 * w93;
    const double w95 = w94 + c[14][l];
    const double w96 = w95 * w41;
    const double w97 = c[73][l] * w96;
    const double w98 = w97 + 5e-06;
    const double w99 = lane_min(w98, w[30][l]);
    const double w100 = -w98;
    const double w101 = lane_max(w100, w99);
    const double w102 = c[76][l] * w96;
    const double w103 = w102 + 0.5;
    const double w104 = (-100000.0) * w101;
    const double w105 = w103 + w104;
    const double w106 = lane_max(0.0, w105);
    const double w107 = w106 * w106;
    const double w108 = w106 * w107;
    const double w109 = (-0.5) * w106;
    const double w110 = w109 + 1.0;
    const double w111 = w108 * w110;
    const double w112 = 100000.0 * w101;
    const double w113 = w103 + w112;
    const double w114 = lane_max(0.0, w113);
    const double w115 = w114 * w114;
    const double w116 = w114 * w115;
    const double w117 = (-0.5) * w114;
    const double w118 = w117 + 1.0;
    const double w119 = w116 * w118;
    const double w120 = 1e-05 * w111;
    const double w121 = w101 + w120;
    const double w122 = (-1e-05) * w119;
    const double w123 = w121 + w122;
    const double w124 = w34 * w123;
    const double w125 = w124 * w37;
    const double w126 = w123 * w123;
    const double w127 = -w126;
    const double w128 = w127 + 1.0;
    const double w129 = sqrt(w128);
    const double w130 = w129 + 5e-06;
    const double w131 = w78 * w[32][l];
    const double w132 = w131 * w41;
    const double w133 = c[73][l] * w132;
    const double w134 = lane_min(w133, c[64][l]);
    const double w135 = lane_max(c[65][l], w134);
    const double w136 = c[9][l] * w135;
    const double w137 = c[67][l] * w135;
    const double w138 = -w130;
    const double w139 = (-100000.0) * w129;
    const double w140 = w139 + 0.5;
    const double w141 = c[77][l] * w125;
    const double w142 = c[50][l] * w28;
    const double w143 = w142 + w30;
    const double w144 = c[52][l] * w143;
    const double w145 = lane_max(0.0, w144);
    const double w146 = c[19][l] * w145;
    const double w147 = w146 + c[18][l];
    const double w148 = lane_max(0.001, w147);
    const double w149 = 1.0 / w148;
    const double w150 = c[80][l] * w149;
    const double w151 = w150 + 5e-06;
    const double w152 = lane_min(w151, w[50][l]);
    const double w153 = -w151;
    const double w154 = lane_max(w153, w152);
    const double w155 = c[82][l] * w149;
    const double w156 = w155 + 0.5;
    const double w157 = (-100000.0) * w154;
    const double w158 = w156 + w157;
    const double w159 = lane_max(0.0, w158);
    const double w160 = w159 * w159;
    const double w161 = w159 * w160;
    const double w162 = (-0.5) * w159;
    const double w163 = w162 + 1.0;
    const double w164 = w161 * w163;
    const double w165 = 100000.0 * w154;
    const double w166 = w156 + w165;
    const double w167 = lane_max(0.0, w166);
    const double w168 = w167 * w167;
    const double w169 = w167 * w168;
    const double w170 = (-0.5) * w167;
    const double w171 = w170 + 1.0;
    const double w172 = w169 * w171;
    const double w173 = 1e-05 * w164;
    const double w174 = w154 + w173;
    const double w175 = (-1e-05) * w172;
    const double w176 = w174 + w175;
    const double w177 = w176 * w176;
    const double w178 = -w177;
    const double w179 = w178 + 1.0;
    const double w180 = sqrt(w179);
    const double w181 = w180 + 5e-06;
    const double w182 = c[17][l] * w145;
    const double w183 = w182 + c[16][l];
    const double w184 = lane_max(0.0, w183);
    const double w185 = w184 * w[52][l];
    const double w186 = w185 * w149;
    const double w187 = c[79][l] * w186;
    const double w188 = lane_min(w187, c[83][l]);
    const double w189 = lane_max(c[84][l], w188);
    const double w190 = c[21][l] * w189;
    const double w191 = c[86][l] * w189;
    const double w192 = -w181;
    const double w193 = (-100000.0) * w180;
    const double w194 = w193 + 0.5;
    const double w195 = w145 * w176;
    const double w196 = w195 * w148;
    const double w197 = w196 * w[47][l];
    const double w198 = c[94][l] * w197;
    const double w199 = w[60][l] + w198;
    const double w200 = lane_atan2(w[62][l], w[2][l]);
    const double w201 = w[63][l] + w200;
    const double w202 = c[31][l] * w201;
    const double w203 = lane_min(c[96][l], w202);
    const double w204 = lane_max(c[97][l], w203);
    const double w205 = (-5.0) * w204;
    const double w206 = w205 + c[102][l];
    const double w207 = lane_max(0.0, w206);
    const double w208 = w207 * w207;
    const double w209 = w207 * w208;
    const double w210 = (-0.5) * w207;
    const double w211 = w210 + 1.0;
    const double w212 = w209 * w211;
    const double w213 = 5.0 * w204;
    const double w214 = w213 + c[102][l];
    const double w215 = lane_max(0.0, w214);
    const double w216 = w215 * w215;
    const double w217 = w215 * w216;
    const double w218 = (-0.5) * w215;
    const double w219 = w218 + 1.0;
    const double w220 = w217 * w219;
    const double w221 = 0.2 * w212;
    const double w222 = w204 + w221;
    const double w223 = (-0.2) * w220;
    const double w224 = w222 + w223;
    const double w225 = w224 * w[64][l];
    const double w226 = lane_atan2(w[4][l], w[6][l]);
    const double w227 = c[24][l] * w226;
    const double w228 = w[65][l] + w227;
    const double w229 = w[5][l] * w228;
    const double w230 = c[69][l] * w90;
    const double w231 = c[78][l] * w125;
    const double w232 = w196 * w[48][l];
    const double w233 = c[20][l] * w232;
    const double w234 = c[108][l] * w225;
    const double w235 = w[69][l] + w234;
    const double w236 = c[110][l] * w229;
    const double w237 = w235 + w236;
    const double w238 = c[29][l] * w226;
    const double w239 = w[71][l] + w238;
    const double w240 = w[5][l] * w239;
    const double w241 = c[116][l] * w225;
    const double w242 = w[72][l] + w241;
    const double w243 = c[115][l] * w240;
    const double w244 = w242 + w243;
    const double w245 = w47 <= w46 ? 1.0 : 0.0;
    const double w246 = w46 <= w47 ? 1.0 : 0.0;
    const double w247 = w245 + w246;
    const double w248 = 1.0 / w247;
    const double w249 = w245 * w248;
    const double w250 = w45 <= w[13][l] ? 1.0 : 0.0;
    const double w251 = w[13][l] <= w45 ? 1.0 : 0.0;
    const double w252 = w250 + w251;
    const double w253 = 1.0 / w252;
    const double w254 = w250 * w253;
    const double w255 = w43 * w41;
    const double w256 = 0.001 <= w36 ? 1.0 : 0.0;
    const double w257 = w36 <= 0.001 ? 1.0 : 0.0;
    const double w258 = w256 + w257;
    const double w259 = 1.0 / w258;
    const double w260 = w256 * w259;
    const double w261 = 0.0 <= w33 ? 1.0 : 0.0;
    const double w262 = w33 <= 0.0 ? 1.0 : 0.0;
    const double w263 = w261 + w262;
    const double w264 = 1.0 / w263;
    const double w265 = w261 * w264;
    const double w266 = w251 * w253;
    const double w267 = w246 * w248;
    const double w268 = 0.0 <= w52 ? 1.0 : 0.0;
    const double w269 = w52 <= 0.0 ? 1.0 : 0.0;
    const double w270 = w268 + w269;
    const double w271 = 1.0 / w270;
    const double w272 = w268 * w271;
    const double w273 = 0.0 <= w60 ? 1.0 : 0.0;
    const double w274 = w60 <= 0.0 ? 1.0 : 0.0;
    const double w275 = w273 + w274;
    const double w276 = 1.0 / w275;
    const double w277 = w273 * w276;
    const double w278 = 1.0 / w74;
    const double w279 = c[65][l] <= w82 ? 1.0 : 0.0;
    const double w280 = w82 <= c[65][l] ? 1.0 : 0.0;
    const double w281 = w279 + w280;
    const double w282 = 1.0 / w281;
    const double w283 = w279 * w282;
    const double w284 = w81 <= c[64][l] ? 1.0 : 0.0;
    const double w285 = c[64][l] <= w81 ? 1.0 : 0.0;
    const double w286 = w284 + w285;
    const double w287 = 1.0 / w286;
    const double w288 = w284 * w287;
    const double w289 = 0.0 <= w77 ? 1.0 : 0.0;
    const double w290 = w77 <= 0.0 ? 1.0 : 0.0;
    const double w291 = w289 + w290;
    const double w292 = 1.0 / w291;
    const double w293 = w289 * w292;
    const double w294 = w80 * w41;
    const double w295 = w83 * w83;
    const double w296 = c[143][l] * w295;
    const double w297 = w296 + 1.0;
    const double w298 = 1.0 / w297;
    const double w299 = w100 <= w99 ? 1.0 : 0.0;
    const double w300 = w99 <= w100 ? 1.0 : 0.0;
    const double w301 = w299 + w300;
    const double w302 = 1.0 / w301;
    const double w303 = w299 * w302;
    const double w304 = w98 <= w[30][l] ? 1.0 : 0.0;
    const double w305 = w[30][l] <= w98 ? 1.0 : 0.0;
    const double w306 = w304 + w305;
    const double w307 = 1.0 / w306;
    const double w308 = w304 * w307;
    const double w309 = w96 * w41;
    const double w310 = w305 * w307;
    const double w311 = w300 * w302;
    const double w312 = 0.0 <= w105 ? 1.0 : 0.0;
    const double w313 = w105 <= 0.0 ? 1.0 : 0.0;
    const double w314 = w312 + w313;
    const double w315 = 1.0 / w314;
    const double w316 = w312 * w315;
    const double w317 = 0.0 <= w113 ? 1.0 : 0.0;
    const double w318 = w113 <= 0.0 ? 1.0 : 0.0;
    const double w319 = w317 + w318;
    const double w320 = 1.0 / w319;
    const double w321 = w317 * w320;
    const double w322 = 1.0 / w129;
    const double w323 = c[65][l] <= w134 ? 1.0 : 0.0;
    const double w324 = w134 <= c[65][l] ? 1.0 : 0.0;
    const double w325 = w323 + w324;
    const double w326 = 1.0 / w325;
    const double w327 = w323 * w326;
    const double w328 = w133 <= c[64][l] ? 1.0 : 0.0;
    const double w329 = c[64][l] <= w133 ? 1.0 : 0.0;
    const double w330 = w328 + w329;
    const double w331 = 1.0 / w330;
    const double w332 = w328 * w331;
    const double w333 = w132 * w41;
    const double w334 = w135 * w135;
    const double w335 = c[143][l] * w334;
    const double w336 = w335 + 1.0;
    const double w337 = 1.0 / w336;
    const double w338 = 0.0 <= w144 ? 1.0 : 0.0;
    const double w339 = w144 <= 0.0 ? 1.0 : 0.0;
    const double w340 = w338 + w339;
    const double w341 = 1.0 / w340;
    const double w342 = w338 * w341;
    const double w343 = w152 <= w153 ? 1.0 : 0.0;
    const double w344 = w153 <= w152 ? 1.0 : 0.0;
    const double w345 = w343 + w344;
    const double w346 = 1.0 / w345;
    const double w347 = w343 * w346;
    const double w348 = w149 * w149;
    const double w349 = 0.001 <= w147 ? 1.0 : 0.0;
    const double w350 = w147 <= 0.001 ? 1.0 : 0.0;
    const double w351 = w349 + w350;
    const double w352 = 1.0 / w351;
    const double w353 = w349 * w352;
    const double w354 = w344 * w346;
    const double w355 = w[50][l] <= w151 ? 1.0 : 0.0;
    const double w356 = w151 <= w[50][l] ? 1.0 : 0.0;
    const double w357 = w355 + w356;
    const double w358 = 1.0 / w357;
    const double w359 = w355 * w358;
    const double w360 = w356 * w358;
    const double w361 = 0.0 <= w158 ? 1.0 : 0.0;
    const double w362 = w158 <= 0.0 ? 1.0 : 0.0;
    const double w363 = w361 + w362;
    const double w364 = 1.0 / w363;
    const double w365 = w361 * w364;
    const double w366 = 0.0 <= w166 ? 1.0 : 0.0;
    const double w367 = w166 <= 0.0 ? 1.0 : 0.0;
    const double w368 = w366 + w367;
    const double w369 = 1.0 / w368;
    const double w370 = w366 * w369;
    const double w371 = 1.0 / w180;
    const double w372 = c[84][l] <= w188 ? 1.0 : 0.0;
    const double w373 = w188 <= c[84][l] ? 1.0 : 0.0;
    const double w374 = w372 + w373;
    const double w375 = 1.0 / w374;
    const double w376 = w372 * w375;
    const double w377 = w187 <= c[83][l] ? 1.0 : 0.0;
    const double w378 = c[83][l] <= w187 ? 1.0 : 0.0;
    const double w379 = w377 + w378;
    const double w380 = 1.0 / w379;
    const double w381 = w377 * w380;
    const double w382 = 0.0 <= w183 ? 1.0 : 0.0;
    const double w383 = w183 <= 0.0 ? 1.0 : 0.0;
    const double w384 = w382 + w383;
    const double w385 = 1.0 / w384;
    const double w386 = w382 * w385;
    const double w387 = w186 * w149;
    const double w388 = w189 * w189;
    const double w389 = c[161][l] * w388;
    const double w390 = w389 + 1.0;
    const double w391 = 1.0 / w390;
    const double w392 = c[97][l] <= w203 ? 1.0 : 0.0;
    const double w393 = w203 <= c[97][l] ? 1.0 : 0.0;
    const double w394 = w392 + w393;
    const double w395 = 1.0 / w394;
    const double w396 = w392 * w395;
    const double w397 = w202 <= c[96][l] ? 1.0 : 0.0;
    const double w398 = c[96][l] <= w202 ? 1.0 : 0.0;
    const double w399 = w397 + w398;
    const double w400 = 1.0 / w399;
    const double w401 = w397 * w400;
    const double w402 = 0.0 <= w206 ? 1.0 : 0.0;
    const double w403 = w206 <= 0.0 ? 1.0 : 0.0;
    const double w404 = w402 + w403;
    const double w405 = 1.0 / w404;
    const double w406 = w402 * w405;
    const double w407 = 0.0 <= w214 ? 1.0 : 0.0;
    const double w408 = w214 <= 0.0 ? 1.0 : 0.0;
    const double w409 = w407 + w408;
    const double w410 = 1.0 / w409;
    const double w411 = w407 * w410;
    const double w412 = w25 * w[75][l];
    const double w413 = c[46][l] * w412;
    const double w414 = w[76][l] + w413;
    const double w415 = c[39][l] * w412;
    const double w416 = w[77][l] + w415;
    const double w417 = c[51][l] * w416;
    const double w418 = w414 + w417;
    const double w419 = w265 * w418;
    const double w420 = w260 * w419;
    const double w421 = w255 * w420;
    const double w422 = u4 * w420;
    const double w423 = w422 * w41;
    const double w424 = c[139][l] * w421;
    const double w425 = c[140][l] * w423;
    const double w426 = w424 + w425;
    const double w427 = w254 * w426;
    const double w428 = w266 * w[82][l];
    const double w429 = w427 + w428;
    const double w430 = w249 * w429;
    const double w431 = w267 * w426;
    const double w432 = -w431;
    const double w433 = w430 + w432;
    const double w434 = (-100000.0) * w426;
    const double w435 = (-100000.0) * w433;
    const double w436 = w434 + w435;
    const double w437 = w272 * w436;
    const double w438 = w54 * w437;
    const double w439 = w53 * w437;
    const double w440 = w53 * w439;
    const double w441 = 2.0 * w440;
    const double w442 = w438 + w441;
    const double w443 = w57 * w442;
    const double w444 = w55 * w437;
    const double w445 = 100000.0 * w433;
    const double w446 = w434 + w445;
    const double w447 = w277 * w446;
    const double w448 = w62 * w447;
    const double w449 = w61 * w447;
    const double w450 = w61 * w449;
    const double w451 = 2.0 * w450;
    const double w452 = w448 + w451;
    const double w453 = w65 * w452;
    const double w454 = w63 * w447;
    const double w455 = 1e-05 * w443;
    const double w456 = w433 + w455;
    const double w457 = (-5e-06) * w444;
    const double w458 = w456 + w457;
    const double w459 = (-1e-05) * w453;
    const double w460 = w458 + w459;
    const double w461 = 5e-06 * w454;
    const double w462 = w460 + w461;
    const double w463 = w70 * w462;
    const double w464 = w463 * w278;
    const double w465 = w294 * w420;
    const double w466 = w293 * w419;
    const double w467 = w[15][l] * w466;
    const double w468 = w78 * w[84][l];
    const double w469 = c[141][l] * w467;
    const double w470 = w469 + w468;
    const double w471 = w470 * w41;
    const double w472 = c[139][l] * w465;
    const double w473 = c[184][l] * w471;
    const double w474 = w472 + w473;
    const double w475 = w288 * w474;
    const double w476 = w283 * w475;
    const double w477 = w476 * w298;
    const double w478 = c[67][l] * w476;
    const double w479 = c[144][l] * w477;
    const double w480 = w478 + w479;
    const double w481 = (-100000.0) * w464;
    const double w482 = 100000.0 * w464;
    const double w483 = w34 * w462;
    const double w484 = w70 * w419;
    const double w485 = c[53][l] * w484;
    const double w486 = w483 + w485;
    const double w487 = w37 * w486;
    const double w488 = w89 * w420;
    const double w489 = w309 * w420;
    const double w490 = u5 * w420;
    const double w491 = w490 * w41;
    const double w492 = c[151][l] * w489;
    const double w493 = c[152][l] * w491;
    const double w494 = w492 + w493;
    const double w495 = w308 * w494;
    const double w496 = w310 * w[93][l];
    const double w497 = w495 + w496;
    const double w498 = w303 * w497;
    const double w499 = w311 * w494;
    const double w500 = -w499;
    const double w501 = w498 + w500;
    const double w502 = (-100000.0) * w494;
    const double w503 = (-100000.0) * w501;
    const double w504 = w502 + w503;
    const double w505 = w316 * w504;
    const double w506 = w107 * w505;
    const double w507 = w106 * w505;
    const double w508 = w106 * w507;
    const double w509 = 2.0 * w508;
    const double w510 = w506 + w509;
    const double w511 = w110 * w510;
    const double w512 = w108 * w505;
    const double w513 = 100000.0 * w501;
    const double w514 = w502 + w513;
    const double w515 = w321 * w514;
    const double w516 = w115 * w515;
    const double w517 = w114 * w515;
    const double w518 = w114 * w517;
    const double w519 = 2.0 * w518;
    const double w520 = w516 + w519;
    const double w521 = w118 * w520;
    const double w522 = w116 * w515;
    const double w523 = 1e-05 * w511;
    const double w524 = w501 + w523;
    const double w525 = (-5e-06) * w512;
    const double w526 = w524 + w525;
    const double w527 = (-1e-05) * w521;
    const double w528 = w526 + w527;
    const double w529 = 5e-06 * w522;
    const double w530 = w528 + w529;
    const double w531 = w34 * w530;
    const double w532 = w123 * w419;
    const double w533 = c[53][l] * w532;
    const double w534 = w531 + w533;
    const double w535 = w37 * w534;
    const double w536 = w124 * w420;
    const double w537 = w123 * w530;
    const double w538 = w537 * w322;
    const double w539 = w78 * w[95][l];
    const double w540 = w[32][l] * w466;
    const double w541 = c[142][l] * w540;
    const double w542 = w539 + w541;
    const double w543 = w542 * w41;
    const double w544 = w333 * w420;
    const double w545 = c[73][l] * w543;
    const double w546 = c[151][l] * w544;
    const double w547 = w545 + w546;
    const double w548 = w332 * w547;
    const double w549 = w327 * w548;
    const double w550 = w549 * w337;
    const double w551 = c[67][l] * w549;
    const double w552 = c[144][l] * w550;
    const double w553 = w551 + w552;
    const double w554 = (-100000.0) * w538;
    const double w555 = 100000.0 * w538;
    const double w556 = c[113][l] * w416;
    const double w557 = w414 + w556;
    const double w558 = w342 * w557;
    const double w559 = w353 * w558;
    const double w560 = w348 * w559;
    const double w561 = w347 * w560;
    const double w562 = w359 * w[105][l];
    const double w563 = w360 * w560;
    const double w564 = c[156][l] * w563;
    const double w565 = w562 + w564;
    const double w566 = w354 * w565;
    const double w567 = c[155][l] * w561;
    const double w568 = w567 + w566;
    const double w569 = c[157][l] * w560;
    const double w570 = 100000.0 * w568;
    const double w571 = w569 + w570;
    const double w572 = w365 * w571;
    const double w573 = w161 * w572;
    const double w574 = w160 * w572;
    const double w575 = w159 * w572;
    const double w576 = w159 * w575;
    const double w577 = 2.0 * w576;
    const double w578 = w574 + w577;
    const double w579 = w163 * w578;
    const double w580 = c[158][l] * w560;
    const double w581 = w580 + w570;
    const double w582 = w370 * w581;
    const double w583 = w168 * w582;
    const double w584 = w167 * w582;
    const double w585 = w167 * w584;
    const double w586 = 2.0 * w585;
    const double w587 = w583 + w586;
    const double w588 = w171 * w587;
    const double w589 = w169 * w582;
    const double w590 = 5e-06 * w573;
    const double w591 = w568 + w590;
    const double w592 = (-1e-05) * w579;
    const double w593 = w591 + w592;
    const double w594 = (-1e-05) * w588;
    const double w595 = w593 + w594;
    const double w596 = 5e-06 * w589;
    const double w597 = w595 + w596;
    const double w598 = w176 * w597;
    const double w599 = w598 * w371;
    const double w600 = w386 * w558;
    const double w601 = w[52][l] * w600;
    const double w602 = w184 * w[107][l];
    const double w603 = c[159][l] * w601;
    const double w604 = -w602;
    const double w605 = w603 + w604;
    const double w606 = w605 * w149;
    const double w607 = w387 * w559;
    const double w608 = c[79][l] * w606;
    const double w609 = c[160][l] * w607;
    const double w610 = w608 + w609;
    const double w611 = w381 * w610;
    const double w612 = w376 * w611;
    const double w613 = w612 * w391;
    const double w614 = c[86][l] * w612;
    const double w615 = c[162][l] * w613;
    const double w616 = w614 + w615;
    const double w617 = (-100000.0) * w599;
    const double w618 = 100000.0 * w599;
    const double w619 = w176 * w558;
    const double w620 = w145 * w597;
    const double w621 = c[52][l] * w619;
    const double w622 = w621 + w620;
    const double w623 = w148 * w622;
    const double w624 = w195 * w559;
    const double w625 = c[20][l] * w623;
    const double w626 = c[154][l] * w624;
    const double w627 = w625 + w626;
    const double w628 = w[47][l] * w627;
    const double w629 = w228 * w[4][l];
    const double w630 = w401 * w[74][l];
    const double w631 = w396 * w630;
    const double w632 = w406 * w631;
    const double w633 = w209 * w632;
    const double w634 = w208 * w632;
    const double w635 = w207 * w632;
    const double w636 = w207 * w635;
    const double w637 = c[169][l] * w634;
    const double w638 = c[171][l] * w636;
    const double w639 = w637 + w638;
    const double w640 = w211 * w639;
    const double w641 = w411 * w631;
    const double w642 = w216 * w641;
    const double w643 = w215 * w641;
    const double w644 = w215 * w643;
    const double w645 = c[169][l] * w642;
    const double w646 = c[171][l] * w644;
    const double w647 = w645 + w646;
    const double w648 = w219 * w647;
    const double w649 = w217 * w641;
    const double w650 = c[31][l] * w631;
    const double w651 = c[170][l] * w633;
    const double w652 = w650 + w651;
    const double w653 = (-0.2) * w640;
    const double w654 = w652 + w653;
    const double w655 = (-0.2) * w648;
    const double w656 = w654 + w655;
    const double w657 = c[172][l] * w649;
    const double w658 = w656 + w657;
    const double w659 = w[64][l] * w658;
    const double w660 = w224 * w[62][l];
    const double w661 = w265 * w[113][l];
    const double w662 = w260 * w661;
    const double w663 = w255 * w662;
    const double w664 = u4 * w662;
    const double w665 = w664 * w41;
    const double w666 = c[139][l] * w663;
    const double w667 = c[140][l] * w665;
    const double w668 = w666 + w667;
    const double w669 = w254 * w668;
    const double w670 = w266 * w[118][l];
    const double w671 = w669 + w670;
    const double w672 = w249 * w671;
    const double w673 = w267 * w668;
    const double w674 = -w673;
    const double w675 = w672 + w674;
    const double w676 = (-100000.0) * w668;
    const double w677 = (-100000.0) * w675;
    const double w678 = w676 + w677;
    const double w679 = w272 * w678;
    const double w680 = w54 * w679;
    const double w681 = w53 * w679;
    const double w682 = w53 * w681;
    const double w683 = 2.0 * w682;
    const double w684 = w680 + w683;
    const double w685 = w57 * w684;
    const double w686 = w55 * w679;
    const double w687 = 100000.0 * w675;
    const double w688 = w676 + w687;
    const double w689 = w277 * w688;
    const double w690 = w62 * w689;
    const double w691 = w61 * w689;
    const double w692 = w61 * w691;
    const double w693 = 2.0 * w692;
    const double w694 = w690 + w693;
    const double w695 = w65 * w694;
    const double w696 = w63 * w689;
    const double w697 = 1e-05 * w685;
    const double w698 = w675 + w697;
    const double w699 = (-5e-06) * w686;
    const double w700 = w698 + w699;
    const double w701 = (-1e-05) * w695;
    const double w702 = w700 + w701;
    const double w703 = 5e-06 * w696;
    const double w704 = w702 + w703;
    const double w705 = w34 * w704;
    const double w706 = w70 * w661;
    const double w707 = c[53][l] * w706;
    const double w708 = w705 + w707;
    const double w709 = w37 * w708;
    const double w710 = w89 * w662;
    const double w711 = w70 * w704;
    const double w712 = w711 * w278;
    const double w713 = w78 * w[120][l];
    const double w714 = w293 * w661;
    const double w715 = w[15][l] * w714;
    const double w716 = c[142][l] * w715;
    const double w717 = w713 + w716;
    const double w718 = w717 * w41;
    const double w719 = w294 * w662;
    const double w720 = c[55][l] * w718;
    const double w721 = c[139][l] * w719;
    const double w722 = w720 + w721;
    const double w723 = w288 * w722;
    const double w724 = w283 * w723;
    const double w725 = w724 * w298;
    const double w726 = c[67][l] * w724;
    const double w727 = c[144][l] * w725;
    const double w728 = w726 + w727;
    const double w729 = (-100000.0) * w712;
    const double w730 = 100000.0 * w712;
    const double w731 = w309 * w662;
    const double w732 = u5 * w662;
    const double w733 = w732 * w41;
    const double w734 = c[151][l] * w731;
    const double w735 = c[152][l] * w733;
    const double w736 = w734 + w735;
    const double w737 = w308 * w736;
    const double w738 = w310 * w[129][l];
    const double w739 = -w738;
    const double w740 = w737 + w739;
    const double w741 = w303 * w740;
    const double w742 = w311 * w736;
    const double w743 = -w742;
    const double w744 = w741 + w743;
    const double w745 = (-100000.0) * w736;
    const double w746 = (-100000.0) * w744;
    const double w747 = w745 + w746;
    const double w748 = w316 * w747;
    const double w749 = w107 * w748;
    const double w750 = w106 * w748;
    const double w751 = w106 * w750;
    const double w752 = 2.0 * w751;
    const double w753 = w749 + w752;
    const double w754 = w110 * w753;
    const double w755 = w108 * w748;
    const double w756 = 100000.0 * w744;
    const double w757 = w745 + w756;
    const double w758 = w321 * w757;
    const double w759 = w115 * w758;
    const double w760 = w114 * w758;
    const double w761 = w114 * w760;
    const double w762 = 2.0 * w761;
    const double w763 = w759 + w762;
    const double w764 = w118 * w763;
    const double w765 = w116 * w758;
    const double w766 = 1e-05 * w754;
    const double w767 = w744 + w766;
    const double w768 = (-5e-06) * w755;
    const double w769 = w767 + w768;
    const double w770 = (-1e-05) * w764;
    const double w771 = w769 + w770;
    const double w772 = 5e-06 * w765;
    const double w773 = w771 + w772;
    const double w774 = w34 * w773;
    const double w775 = w123 * w661;
    const double w776 = c[53][l] * w775;
    const double w777 = w774 + w776;
    const double w778 = w37 * w777;
    const double w779 = w124 * w662;
    const double w780 = w123 * w773;
    const double w781 = w780 * w322;
    const double w782 = w78 * w[131][l];
    const double w783 = w[32][l] * w714;
    const double w784 = c[142][l] * w783;
    const double w785 = w782 + w784;
    const double w786 = w785 * w41;
    const double w787 = w333 * w662;
    const double w788 = c[73][l] * w786;
    const double w789 = c[151][l] * w787;
    const double w790 = w788 + w789;
    const double w791 = w332 * w790;
    const double w792 = w327 * w791;
    const double w793 = w792 * w337;
    const double w794 = c[67][l] * w792;
    const double w795 = c[144][l] * w793;
    const double w796 = w794 + w795;
    const double w797 = (-100000.0) * w781;
    const double w798 = 100000.0 * w781;
    const double w799 = w342 * w[138][l];
    const double w800 = w176 * w799;
    const double w801 = w353 * w799;
    const double w802 = w348 * w801;
    const double w803 = w347 * w802;
    const double w804 = w359 * w[142][l];
    const double w805 = w360 * w802;
    const double w806 = c[156][l] * w805;
    const double w807 = w804 + w806;
    const double w808 = w354 * w807;
    const double w809 = c[155][l] * w803;
    const double w810 = w809 + w808;
    const double w811 = c[157][l] * w802;
    const double w812 = 100000.0 * w810;
    const double w813 = w811 + w812;
    const double w814 = w365 * w813;
    const double w815 = w161 * w814;
    const double w816 = w160 * w814;
    const double w817 = w159 * w814;
    const double w818 = w159 * w817;
    const double w819 = 2.0 * w818;
    const double w820 = w816 + w819;
    const double w821 = w163 * w820;
    const double w822 = c[158][l] * w802;
    const double w823 = w822 + w812;
    const double w824 = w370 * w823;
    const double w825 = w168 * w824;
    const double w826 = w167 * w824;
    const double w827 = w167 * w826;
    const double w828 = 2.0 * w827;
    const double w829 = w825 + w828;
    const double w830 = w171 * w829;
    const double w831 = w169 * w824;
    const double w832 = 5e-06 * w815;
    const double w833 = w810 + w832;
    const double w834 = (-1e-05) * w821;
    const double w835 = w833 + w834;
    const double w836 = (-1e-05) * w830;
    const double w837 = w835 + w836;
    const double w838 = 5e-06 * w831;
    const double w839 = w837 + w838;
    const double w840 = w145 * w839;
    const double w841 = c[52][l] * w800;
    const double w842 = w841 + w840;
    const double w843 = w148 * w842;
    const double w844 = w195 * w801;
    const double w845 = c[20][l] * w843;
    const double w846 = c[154][l] * w844;
    const double w847 = w845 + w846;
    const double w848 = w[48][l] * w847;
    const double w849 = w176 * w839;
    const double w850 = w849 * w371;
    const double w851 = w386 * w799;
    const double w852 = w[52][l] * w851;
    const double w853 = w184 * w[145][l];
    const double w854 = c[159][l] * w852;
    const double w855 = w854 + w853;
    const double w856 = w855 * w149;
    const double w857 = w387 * w801;
    const double w858 = c[79][l] * w856;
    const double w859 = c[160][l] * w857;
    const double w860 = w858 + w859;
    const double w861 = w381 * w860;
    const double w862 = w376 * w861;
    const double w863 = w862 * w391;
    const double w864 = c[86][l] * w862;
    const double w865 = c[162][l] * w863;
    const double w866 = w864 + w865;
    const double w867 = (-100000.0) * w850;
    const double w868 = 100000.0 * w850;
    const double w869 = c[214][l] * w634;
    const double w870 = c[216][l] * w636;
    const double w871 = w869 + w870;
    const double w872 = w211 * w871;
    const double w873 = c[214][l] * w642;
    const double w874 = c[216][l] * w644;
    const double w875 = w873 + w874;
    const double w876 = w219 * w875;
    const double w877 = c[213][l] * w631;
    const double w878 = c[215][l] * w633;
    const double w879 = w877 + w878;
    const double w880 = c[217][l] * w649;
    const double w881 = w879 + w880;
    const double w882 = (-0.2) * w872;
    const double w883 = w881 + w882;
    const double w884 = (-0.2) * w876;
    const double w885 = w883 + w884;
    const double w886 = w[64][l] * w885;
    const double w887 = w266 * w[153][l];
    const double w888 = w249 * w887;
    const double w889 = w272 * w888;
    const double w890 = w55 * w889;
    const double w891 = w54 * w889;
    const double w892 = w53 * w889;
    const double w893 = w53 * w892;
    const double w894 = 100000.0 * w891;
    const double w895 = 200000.0 * w893;
    const double w896 = w894 + w895;
    const double w897 = w57 * w896;
    const double w898 = w277 * w888;
    const double w899 = w62 * w898;
    const double w900 = w61 * w898;
    const double w901 = w61 * w900;
    const double w902 = 100000.0 * w899;
    const double w903 = 200000.0 * w901;
    const double w904 = w902 + w903;
    const double w905 = w65 * w904;
    const double w906 = w63 * w898;
    const double w907 = 0.5 * w890;
    const double w908 = w888 + w907;
    const double w909 = (-1e-05) * w897;
    const double w910 = w908 + w909;
    const double w911 = (-1e-05) * w905;
    const double w912 = w910 + w911;
    const double w913 = 0.5 * w906;
    const double w914 = w912 + w913;
    const double w915 = w70 * w914;
    const double w916 = w915 * w278;
    const double w917 = w78 * w[155][l];
    const double w918 = w917 * w41;
    const double w919 = w288 * w918;
    const double w920 = w283 * w919;
    const double w921 = w920 * w298;
    const double w922 = c[225][l] * w920;
    const double w923 = c[226][l] * w921;
    const double w924 = w922 + w923;
    const double w925 = (-100000.0) * w916;
    const double w926 = 100000.0 * w916;
    const double w927 = w34 * w914;
    const double w928 = w37 * w927;
    const double w929 = w310 * w[164][l];
    const double w930 = w303 * w929;
    const double w931 = w316 * w930;
    const double w932 = w107 * w931;
    const double w933 = w106 * w931;
    const double w934 = w106 * w933;
    const double w935 = 100000.0 * w932;
    const double w936 = 200000.0 * w934;
    const double w937 = w935 + w936;
    const double w938 = w110 * w937;
    const double w939 = w108 * w931;
    const double w940 = w321 * w930;
    const double w941 = w116 * w940;
    const double w942 = w115 * w940;
    const double w943 = w114 * w940;
    const double w944 = w114 * w943;
    const double w945 = 100000.0 * w942;
    const double w946 = 200000.0 * w944;
    const double w947 = w945 + w946;
    const double w948 = w118 * w947;
    const double w949 = -w930;
    const double w950 = 1e-05 * w938;
    const double w951 = w949 + w950;
    const double w952 = (-0.5) * w939;
    const double w953 = w951 + w952;
    const double w954 = (-0.5) * w941;
    const double w955 = w953 + w954;
    const double w956 = 1e-05 * w948;
    const double w957 = w955 + w956;
    const double w958 = w34 * w957;
    const double w959 = w37 * w958;
    const double w960 = w123 * w957;
    const double w961 = w960 * w322;
    const double w962 = w78 * w[166][l];
    const double w963 = w962 * w41;
    const double w964 = w332 * w963;
    const double w965 = w327 * w964;
    const double w966 = w965 * w337;
    const double w967 = c[230][l] * w965;
    const double w968 = c[231][l] * w966;
    const double w969 = w967 + w968;
    const double w970 = (-100000.0) * w961;
    const double w971 = 100000.0 * w961;
    const double w972 = w359 * w[174][l];
    const double w973 = w354 * w972;
    const double w974 = w365 * w973;
    const double w975 = w161 * w974;
    const double w976 = w160 * w974;
    const double w977 = w159 * w974;
    const double w978 = w159 * w977;
    const double w979 = 100000.0 * w976;
    const double w980 = 200000.0 * w978;
    const double w981 = w979 + w980;
    const double w982 = w163 * w981;
    const double w983 = w370 * w973;
    const double w984 = w168 * w983;
    const double w985 = w167 * w983;
    const double w986 = w167 * w985;
    const double w987 = 100000.0 * w984;
    const double w988 = 200000.0 * w986;
    const double w989 = w987 + w988;
    const double w990 = w171 * w989;
    const double w991 = w169 * w983;
    const double w992 = 0.5 * w975;
    const double w993 = w973 + w992;
    const double w994 = (-1e-05) * w982;
    const double w995 = w993 + w994;
    const double w996 = (-1e-05) * w990;
    const double w997 = w995 + w996;
    const double w998 = 0.5 * w991;
    const double w999 = w997 + w998;
    const double w1000 = w145 * w999;
    const double w1001 = w148 * w1000;
    const double w1002 = w[48][l] * w1001;
    const double w1003 = w176 * w999;
    const double w1004 = w1003 * w371;
    const double w1005 = w184 * w[176][l];
    const double w1006 = w1005 * w149;
    const double w1007 = w381 * w1006;
    const double w1008 = w376 * w1007;
    const double w1009 = w1008 * w391;
    const double w1010 = c[235][l] * w1008;
    const double w1011 = c[234][l] * w1009;
    const double w1012 = w1010 + w1011;
    const double w1013 = (-100000.0) * w1004;
    const double w1014 = 100000.0 * w1004;
    const double w1015 = c[92][l] * w628;
    const double w1016 = c[203][l] * w629;
    const double w1017 = c[8][l] * w487;
    const double w1018 = c[149][l] * w488;
    const double w1019 = w1017 + w1018;
    const double w1020 = c[150][l] * w1019;
    const double w1021 = c[13][l] * w535;
    const double w1022 = c[153][l] * w536;
    const double w1023 = w1021 + w1022;
    const double w1024 = c[58][l] * w1023;
    const double w1025 = w[185][l] + w1015;
    const double w1026 = w228 * w[0][l];
    const double w1027 = w401 * w[187][l];
    const double w1028 = w396 * w1027;
    const double w1029 = w406 * w1028;
    const double w1030 = w208 * w1029;
    const double w1031 = w207 * w1029;
    const double w1032 = w207 * w1031;
    const double w1033 = c[244][l] * w1030;
    const double w1034 = c[245][l] * w1032;
    const double w1035 = w1033 + w1034;
    const double w1036 = w211 * w1035;
    const double w1037 = w209 * w1029;
    const double w1038 = w411 * w1028;
    const double w1039 = w217 * w1038;
    const double w1040 = w216 * w1038;
    const double w1041 = w215 * w1038;
    const double w1042 = w215 * w1041;
    const double w1043 = c[244][l] * w1040;
    const double w1044 = c[245][l] * w1042;
    const double w1045 = w1043 + w1044;
    const double w1046 = w219 * w1045;
    const double w1047 = c[247][l] * w1028;
    const double w1048 = 0.2 * w1036;
    const double w1049 = w1047 + w1048;
    const double w1050 = c[246][l] * w1037;
    const double w1051 = w1049 + w1050;
    const double w1052 = c[246][l] * w1039;
    const double w1053 = w1051 + w1052;
    const double w1054 = 0.2 * w1046;
    const double w1055 = w1053 + w1054;
    const double w1056 = w[64][l] * w1055;
    const double w1057 = w224 * w[75][l];
    const double w1058 = c[103][l] * w1056;
    const double w1059 = c[103][l] * w1057;
    const double w1060 = w1058 + w1059;
    const double w1061 = c[56][l] * w1019;
    const double w1062 = c[56][l] * w1023;
    const double w1063 = w[48][l] * w627;
    const double w1064 = c[203][l] * w1026;
    const double w1065 = w[191][l] + w1064;
    const double w1066 = c[92][l] * w1060;
    const double w1067 = w1065 + w1066;
    const double w1068 = w239 * w[0][l];
    const double w1069 = c[177][l] * w1060;
    const double w1070 = w[193][l] + w1069;
    const double w1071 = c[249][l] * w1068;
    const double w1072 = w1070 + w1071;
    const double w1073 = c[8][l] * w709;
    const double w1074 = c[149][l] * w710;
    const double w1075 = w1073 + w1074;
    const double w1076 = c[150][l] * w1075;
    const double w1077 = c[13][l] * w778;
    const double w1078 = c[153][l] * w779;
    const double w1079 = w1077 + w1078;
    const double w1080 = c[58][l] * w1079;
    const double w1081 = w[47][l] * w847;
    const double w1082 = c[92][l] * w1081;
    const double w1083 = w[197][l] + w1082;
    const double w1084 = c[103][l] * w659;
    const double w1085 = c[189][l] * w660;
    const double w1086 = w1084 + w1085;
    const double w1087 = c[56][l] * w1075;
    const double w1088 = c[56][l] * w1079;
    const double w1089 = w[201][l] + w1016;
    const double w1090 = c[92][l] * w1086;
    const double w1091 = w1089 + w1090;
    const double w1092 = w239 * w[4][l];
    const double w1093 = c[177][l] * w1086;
    const double w1094 = w[203][l] + w1093;
    const double w1095 = c[249][l] * w1092;
    const double w1096 = w1094 + w1095;
    const double w1097 = c[71][l] * w928;
    const double w1098 = c[77][l] * w959;
    const double w1099 = w[47][l] * w1001;
    const double w1100 = c[94][l] * w1099;
    const double w1101 = x1 + w1100;
    const double w1102 = c[218][l] * w660;
    const double w1103 = c[103][l] * w886;
    const double w1104 = w1102 + w1103;
    const double w1105 = c[69][l] * w928;
    const double w1106 = c[78][l] * w959;
    const double w1107 = c[20][l] * w1002;
    const double w1108 = c[92][l] * w1104;
    const double w1109 = w[211][l] + w1108;
    const double w1110 = c[177][l] * w1104;
    const double w1111 = w[182][l] + w1110;
    const double w1112 = w25 * w[214][l];
    const double w1113 = c[46][l] * w1112;
    const double w1114 = w[216][l] + w1113;
    const double w1115 = c[39][l] * w1112;
    const double w1116 = w[217][l] + w1115;
    const double w1117 = c[51][l] * w1116;
    const double w1118 = w1114 + w1117;
    const double w1119 = w265 * w1118;
    const double w1120 = w260 * w1119;
    const double w1121 = w255 * w1120;
    const double w1122 = u4 * w1120;
    const double w1123 = w1122 * w41;
    const double w1124 = c[139][l] * w1121;
    const double w1125 = c[140][l] * w1123;
    const double w1126 = w1124 + w1125;
    const double w1127 = w254 * w1126;
    const double w1128 = w249 * w1127;
    const double w1129 = w267 * w1126;
    const double w1130 = -w1129;
    const double w1131 = w1128 + w1130;
    const double w1132 = (-100000.0) * w1126;
    const double w1133 = (-100000.0) * w1131;
    const double w1134 = w1132 + w1133;
    const double w1135 = w272 * w1134;
    const double w1136 = w54 * w1135;
    const double w1137 = w53 * w1135;
    const double w1138 = w53 * w1137;
    const double w1139 = 2.0 * w1138;
    const double w1140 = w1136 + w1139;
    const double w1141 = w57 * w1140;
    const double w1142 = w55 * w1135;
    const double w1143 = 100000.0 * w1131;
    const double w1144 = w1132 + w1143;
    const double w1145 = w277 * w1144;
    const double w1146 = w62 * w1145;
    const double w1147 = w61 * w1145;
    const double w1148 = w61 * w1147;
    const double w1149 = 2.0 * w1148;
    const double w1150 = w1146 + w1149;
    const double w1151 = w65 * w1150;
    const double w1152 = w63 * w1145;
    const double w1153 = 1e-05 * w1141;
    const double w1154 = w1131 + w1153;
    const double w1155 = (-5e-06) * w1142;
    const double w1156 = w1154 + w1155;
    const double w1157 = (-1e-05) * w1151;
    const double w1158 = w1156 + w1157;
    const double w1159 = 5e-06 * w1152;
    const double w1160 = w1158 + w1159;
    const double w1161 = w70 * w1160;
    const double w1162 = w1161 * w278;
    const double w1163 = w294 * w1120;
    const double w1164 = w293 * w1119;
    const double w1165 = w[15][l] * w1164;
    const double w1166 = w1165 * w41;
    const double w1167 = c[139][l] * w1163;
    const double w1168 = c[252][l] * w1166;
    const double w1169 = w1167 + w1168;
    const double w1170 = w288 * w1169;
    const double w1171 = w283 * w1170;
    const double w1172 = w1171 * w298;
    const double w1173 = c[67][l] * w1171;
    const double w1174 = c[144][l] * w1172;
    const double w1175 = w1173 + w1174;
    const double w1176 = (-100000.0) * w1162;
    const double w1177 = 100000.0 * w1162;
    const double w1178 = w34 * w1160;
    const double w1179 = w70 * w1119;
    const double w1180 = c[53][l] * w1179;
    const double w1181 = w1178 + w1180;
    const double w1182 = w37 * w1181;
    const double w1183 = w89 * w1120;
    const double w1184 = c[8][l] * w1182;
    const double w1185 = c[149][l] * w1183;
    const double w1186 = w1184 + w1185;
    const double w1187 = c[150][l] * w1186;
    const double w1188 = w309 * w1120;
    const double w1189 = u5 * w1120;
    const double w1190 = w1189 * w41;
    const double w1191 = c[151][l] * w1188;
    const double w1192 = c[152][l] * w1190;
    const double w1193 = w1191 + w1192;
    const double w1194 = w308 * w1193;
    const double w1195 = w303 * w1194;
    const double w1196 = w311 * w1193;
    const double w1197 = -w1196;
    const double w1198 = w1195 + w1197;
    const double w1199 = (-100000.0) * w1193;
    const double w1200 = (-100000.0) * w1198;
    const double w1201 = w1199 + w1200;
    const double w1202 = w316 * w1201;
    const double w1203 = w107 * w1202;
    const double w1204 = w106 * w1202;
    const double w1205 = w106 * w1204;
    const double w1206 = 2.0 * w1205;
    const double w1207 = w1203 + w1206;
    const double w1208 = w110 * w1207;
    const double w1209 = w108 * w1202;
    const double w1210 = 100000.0 * w1198;
    const double w1211 = w1199 + w1210;
    const double w1212 = w321 * w1211;
    const double w1213 = w115 * w1212;
    const double w1214 = w114 * w1212;
    const double w1215 = w114 * w1214;
    const double w1216 = 2.0 * w1215;
    const double w1217 = w1213 + w1216;
    const double w1218 = w118 * w1217;
    const double w1219 = w116 * w1212;
    const double w1220 = 1e-05 * w1208;
    const double w1221 = w1198 + w1220;
    const double w1222 = (-5e-06) * w1209;
    const double w1223 = w1221 + w1222;
    const double w1224 = (-1e-05) * w1218;
    const double w1225 = w1223 + w1224;
    const double w1226 = 5e-06 * w1219;
    const double w1227 = w1225 + w1226;
    const double w1228 = w34 * w1227;
    const double w1229 = w123 * w1119;
    const double w1230 = c[53][l] * w1229;
    const double w1231 = w1228 + w1230;
    const double w1232 = w37 * w1231;
    const double w1233 = w124 * w1120;
    const double w1234 = c[13][l] * w1232;
    const double w1235 = c[153][l] * w1233;
    const double w1236 = w1234 + w1235;
    const double w1237 = w123 * w1227;
    const double w1238 = w1237 * w322;
    const double w1239 = w333 * w1120;
    const double w1240 = w[32][l] * w1164;
    const double w1241 = w1240 * w41;
    const double w1242 = c[151][l] * w1239;
    const double w1243 = c[258][l] * w1241;
    const double w1244 = w1242 + w1243;
    const double w1245 = w332 * w1244;
    const double w1246 = w327 * w1245;
    const double w1247 = w1246 * w337;
    const double w1248 = c[67][l] * w1246;
    const double w1249 = c[144][l] * w1247;
    const double w1250 = w1248 + w1249;
    const double w1251 = (-100000.0) * w1238;
    const double w1252 = 100000.0 * w1238;
    const double w1253 = c[58][l] * w1236;
    const double w1254 = c[113][l] * w1116;
    const double w1255 = w1114 + w1254;
    const double w1256 = w342 * w1255;
    const double w1257 = w353 * w1256;
    const double w1258 = w348 * w1257;
    const double w1259 = w347 * w1258;
    const double w1260 = w360 * w1258;
    const double w1261 = w354 * w1260;
    const double w1262 = c[155][l] * w1259;
    const double w1263 = c[156][l] * w1261;
    const double w1264 = w1262 + w1263;
    const double w1265 = c[157][l] * w1258;
    const double w1266 = 100000.0 * w1264;
    const double w1267 = w1265 + w1266;
    const double w1268 = w365 * w1267;
    const double w1269 = w161 * w1268;
    const double w1270 = w160 * w1268;
    const double w1271 = w159 * w1268;
    const double w1272 = w159 * w1271;
    const double w1273 = 2.0 * w1272;
    const double w1274 = w1270 + w1273;
    const double w1275 = w163 * w1274;
    const double w1276 = c[158][l] * w1258;
    const double w1277 = w1276 + w1266;
    const double w1278 = w370 * w1277;
    const double w1279 = w168 * w1278;
    const double w1280 = w167 * w1278;
    const double w1281 = w167 * w1280;
    const double w1282 = 2.0 * w1281;
    const double w1283 = w1279 + w1282;
    const double w1284 = w171 * w1283;
    const double w1285 = w169 * w1278;
    const double w1286 = 5e-06 * w1269;
    const double w1287 = w1264 + w1286;
    const double w1288 = (-1e-05) * w1275;
    const double w1289 = w1287 + w1288;
    const double w1290 = (-1e-05) * w1284;
    const double w1291 = w1289 + w1290;
    const double w1292 = 5e-06 * w1285;
    const double w1293 = w1291 + w1292;
    const double w1294 = w176 * w1293;
    const double w1295 = w1294 * w371;
    const double w1296 = w386 * w1256;
    const double w1297 = w[52][l] * w1296;
    const double w1298 = w1297 * w149;
    const double w1299 = w387 * w1257;
    const double w1300 = c[259][l] * w1298;
    const double w1301 = c[160][l] * w1299;
    const double w1302 = w1300 + w1301;
    const double w1303 = w381 * w1302;
    const double w1304 = w376 * w1303;
    const double w1305 = w1304 * w391;
    const double w1306 = c[86][l] * w1304;
    const double w1307 = c[162][l] * w1305;
    const double w1308 = w1306 + w1307;
    const double w1309 = (-100000.0) * w1295;
    const double w1310 = 100000.0 * w1295;
    const double w1311 = w176 * w1256;
    const double w1312 = w145 * w1293;
    const double w1313 = c[52][l] * w1311;
    const double w1314 = w1313 + w1312;
    const double w1315 = w148 * w1314;
    const double w1316 = w195 * w1257;
    const double w1317 = c[20][l] * w1315;
    const double w1318 = c[154][l] * w1316;
    const double w1319 = w1317 + w1318;
    const double w1320 = w[47][l] * w1319;
    const double w1321 = c[92][l] * w1320;
    const double w1322 = w[239][l] + w1321;
    const double w1323 = w228 * w[215][l];
    const double w1324 = w401 * w[241][l];
    const double w1325 = w396 * w1324;
    const double w1326 = w406 * w1325;
    const double w1327 = w209 * w1326;
    const double w1328 = w208 * w1326;
    const double w1329 = w207 * w1326;
    const double w1330 = w207 * w1329;
    const double w1331 = c[169][l] * w1328;
    const double w1332 = c[171][l] * w1330;
    const double w1333 = w1331 + w1332;
    const double w1334 = w211 * w1333;
    const double w1335 = w411 * w1325;
    const double w1336 = w216 * w1335;
    const double w1337 = w215 * w1335;
    const double w1338 = w215 * w1337;
    const double w1339 = c[169][l] * w1336;
    const double w1340 = c[171][l] * w1338;
    const double w1341 = w1339 + w1340;
    const double w1342 = w219 * w1341;
    const double w1343 = w217 * w1335;
    const double w1344 = c[31][l] * w1325;
    const double w1345 = c[170][l] * w1327;
    const double w1346 = w1344 + w1345;
    const double w1347 = (-0.2) * w1334;
    const double w1348 = w1346 + w1347;
    const double w1349 = (-0.2) * w1342;
    const double w1350 = w1348 + w1349;
    const double w1351 = c[172][l] * w1343;
    const double w1352 = w1350 + w1351;
    const double w1353 = w[64][l] * w1352;
    const double w1354 = w224 * w[242][l];
    const double w1355 = c[103][l] * w1353;
    const double w1356 = c[103][l] * w1354;
    const double w1357 = w1355 + w1356;
    const double w1358 = c[56][l] * w1186;
    const double w1359 = c[56][l] * w1236;
    const double w1360 = w[48][l] * w1319;
    const double w1361 = c[110][l] * w1323;
    const double w1362 = w[246][l] + w1361;
    const double w1363 = c[92][l] * w1357;
    const double w1364 = w1362 + w1363;
    const double w1365 = w239 * w[215][l];
    const double w1366 = c[177][l] * w1357;
    const double w1367 = w[248][l] + w1366;
    const double w1368 = c[115][l] * w1365;
    const double w1369 = w1367 + w1368;
    w[9][l] = w34;
    w[10][l] = w37;
    w[14][l] = w75;
    w[16][l] = w84;
    w[17][l] = w85;
    w[25][l] = w86;
    w[26][l] = w88;
    w[27][l] = w91;
    w[31][l] = w130;
    w[33][l] = w136;
    w[34][l] = w137;
    w[42][l] = w138;
    w[43][l] = w140;
    w[44][l] = w141;
    w[45][l] = w145;
    w[46][l] = w148;
    w[51][l] = w181;
    w[53][l] = w190;
    w[54][l] = w191;
    w[58][l] = w192;
    w[59][l] = w194;
    w[61][l] = w199;
    w[66][l] = w230;
    w[67][l] = w231;
    w[68][l] = w233;
    w[70][l] = w237;
    w[73][l] = w244;
    w[78][l] = w419;
    w[79][l] = w420;
    w[83][l] = w464;
    w[85][l] = w480;
    w[89][l] = w481;
    w[90][l] = w482;
    w[94][l] = w538;
    w[96][l] = w553;
    w[100][l] = w554;
    w[101][l] = w555;
    w[102][l] = w558;
    w[103][l] = w559;
    w[106][l] = w599;
    w[108][l] = w616;
    w[111][l] = w617;
    w[112][l] = w618;
    w[114][l] = w661;
    w[115][l] = w662;
    w[119][l] = w712;
    w[121][l] = w728;
    w[125][l] = w729;
    w[126][l] = w730;
    w[130][l] = w781;
    w[132][l] = w796;
    w[136][l] = w797;
    w[137][l] = w798;
    w[139][l] = w799;
    w[140][l] = w801;
    w[143][l] = w848;
    w[144][l] = w850;
    w[146][l] = w866;
    w[149][l] = w867;
    w[150][l] = w868;
    w[154][l] = w916;
    w[156][l] = w924;
    w[160][l] = w925;
    w[161][l] = w926;
    w[165][l] = w961;
    w[167][l] = w969;
    w[171][l] = w970;
    w[172][l] = w971;
    w[175][l] = w1004;
    w[177][l] = w1012;
    w[180][l] = w1013;
    w[181][l] = w1014;
    w[183][l] = w1020;
    w[184][l] = w1024;
    w[186][l] = w1025;
    w[188][l] = w1061;
    w[189][l] = w1062;
    w[190][l] = w1063;
    w[192][l] = w1067;
    w[194][l] = w1072;
    w[195][l] = w1076;
    w[196][l] = w1080;
    w[198][l] = w1083;
    w[199][l] = w1087;
    w[200][l] = w1088;
    w[202][l] = w1091;
    w[204][l] = w1096;
    w[205][l] = w1097;
    w[206][l] = w1098;
    w[207][l] = w1101;
    w[208][l] = w1105;
    w[209][l] = w1106;
    w[210][l] = w1107;
    w[212][l] = w1109;
    w[213][l] = w1111;
    w[218][l] = w1119;
    w[219][l] = w1120;
    w[220][l] = w1162;
    w[221][l] = w1175;
    w[223][l] = w1176;
    w[224][l] = w1177;
    w[225][l] = w1187;
    w[226][l] = w1238;
    w[227][l] = w1250;
    w[229][l] = w1251;
    w[230][l] = w1252;
    w[231][l] = w1253;
    w[232][l] = w1256;
    w[233][l] = w1257;
    w[234][l] = w1295;
    w[235][l] = w1308;
    w[237][l] = w1309;
    w[238][l] = w1310;
    w[240][l] = w1322;
    w[243][l] = w1358;
    w[244][l] = w1359;
    w[245][l] = w1360;
    w[247][l] = w1364;
    w[249][l] = w1369;
}

INLINE void entry2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1], lanes *w, int l)
{
    const double w0 = lane_atan(w[16][l]);
    const double w1 = c[68][l] * w0;
    const double w2 = w[17][l] + w1;
    const double w3 = c[9][l] * w2;
    const double w4 = lane_atan(w[33][l]);
    const double w5 = c[68][l] * w4;
    const double w6 = w[34][l] + w5;
    const double w7 = c[9][l] * w6;
    const double w8 = lane_atan(w[53][l]);
    const double w9 = c[85][l] * w8;
    const double w10 = w[54][l] + w9;
    const double w11 = c[21][l] * w10;
    const double w12 = w2 * w2;
    const double w13 = c[143][l] * w12;
    const double w14 = w13 + 1.0;
    const double w15 = 1.0 / w14;
    const double w16 = w6 * w6;
    const double w17 = c[143][l] * w16;
    const double w18 = w17 + 1.0;
    const double w19 = 1.0 / w18;
    const double w20 = w10 * w10;
    const double w21 = c[161][l] * w20;
    const double w22 = w21 + 1.0;
    const double w23 = 1.0 / w22;
    const double w24 = w[85][l] * w15;
    const double w25 = w[96][l] * w19;
    const double w26 = w[108][l] * w23;
    const double w27 = w[121][l] * w15;
    const double w28 = w[132][l] * w19;
    const double w29 = w[146][l] * w23;
    const double w30 = w[156][l] * w15;
    const double w31 = w[167][l] * w19;
    const double w32 = w[177][l] * w23;
    const double w33 = w[221][l] * w15;
    const double w34 = w[227][l] * w19;
    const double w35 = w[235][l] * w23;
    w[18][l] = w3;
    w[35][l] = w7;
    w[55][l] = w11;
    w[86][l] = w24;
    w[97][l] = w25;
    w[109][l] = w26;
    w[122][l] = w27;
    w[133][l] = w28;
    w[147][l] = w29;
    w[157][l] = w30;
    w[168][l] = w31;
    w[178][l] = w32;
    w[222][l] = w33;
    w[228][l] = w34;
    w[236][l] = w35;
}

INLINE void entry3(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1], lanes *w, int l)
{
    const double w0 = lane_atan(w[18][l]);
    const double w1 = c[10][l] * w0;
    const double w2 = lane_atan(w[35][l]);
    const double w3 = c[10][l] * w2;
    const double w4 = lane_atan(w[55][l]);
    const double w5 = c[22][l] * w4;
    w[19][l] = w1;
    w[36][l] = w3;
    w[56][l] = w5;
}

INLINE void entry4(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1], lanes *w, int l)
{
    const double w0 = lane_sin(w[19][l]);
    const double w1 = w0 * w[20][l];
    const double w2 = w[11][l] * w1;
    const double w3 = w2 * w[21][l];
    const double w4 = c[11][l] * w3;
    const double w5 = w4 + 1e-12;
    const double w6 = w5 * w[22][l];
    const double w7 = (-50.0) * w6;
    const double w8 = w[23][l] + w7;
    const double w9 = lane_min(1.0, w8);
    const double w10 = lane_max(0.0, w9);
    const double w11 = w10 * w10;
    const double w12 = w10 * w11;
    const double w13 = (-8.0) * w10;
    const double w14 = w13 + 6.0;
    const double w15 = 3.0 * w11;
    const double w16 = w14 + w15;
    const double w17 = w12 * w16;
    const double w18 = -w6;
    const double w19 = w[24][l] + w18;
    const double w20 = lane_max(0.0, w19);
    const double w21 = 0.02 * w17;
    const double w22 = w21 + w20;
    const double w23 = w[11][l] * w22;
    const double w24 = w23 * w[12][l];
    const double w25 = w1 * w[12][l];
    const double w26 = c[11][l] * w25;
    const double w27 = w24 + w26;
    const double w28 = lane_min(w27, w[14][l]);
    const double w29 = lane_max(w[25][l], w28);
    const double w30 = (-100000.0) * w29;
    const double w31 = w[26][l] + w30;
    const double w32 = lane_max(0.0, w31);
    const double w33 = w32 * w32;
    const double w34 = w32 * w33;
    const double w35 = (-0.5) * w32;
    const double w36 = w35 + 1.0;
    const double w37 = w34 * w36;
    const double w38 = 100000.0 * w29;
    const double w39 = w[26][l] + w38;
    const double w40 = lane_max(0.0, w39);
    const double w41 = w40 * w40;
    const double w42 = w40 * w41;
    const double w43 = (-0.5) * w40;
    const double w44 = w43 + 1.0;
    const double w45 = w42 * w44;
    const double w46 = 1e-05 * w37;
    const double w47 = w29 + w46;
    const double w48 = (-1e-05) * w45;
    const double w49 = w47 + w48;
    const double w50 = w[9][l] * w49;
    const double w51 = w50 * w[10][l];
    const double w52 = c[69][l] * w51;
    const double w53 = w[27][l] + w52;
    const double w54 = lane_sin(w[36][l]);
    const double w55 = w54 * w[37][l];
    const double w56 = w[28][l] * w55;
    const double w57 = w56 * w[38][l];
    const double w58 = c[11][l] * w57;
    const double w59 = w58 + 1e-12;
    const double w60 = w59 * w[39][l];
    const double w61 = (-50.0) * w60;
    const double w62 = w[40][l] + w61;
    const double w63 = lane_min(1.0, w62);
    const double w64 = lane_max(0.0, w63);
    const double w65 = w64 * w64;
    const double w66 = w64 * w65;
    const double w67 = (-8.0) * w64;
    const double w68 = w67 + 6.0;
    const double w69 = 3.0 * w65;
    const double w70 = w68 + w69;
    const double w71 = w66 * w70;
    const double w72 = -w60;
    const double w73 = w[41][l] + w72;
    const double w74 = lane_max(0.0, w73);
    const double w75 = 0.02 * w71;
    const double w76 = w75 + w74;
    const double w77 = w[28][l] * w76;
    const double w78 = w77 * w[29][l];
    const double w79 = w55 * w[29][l];
    const double w80 = c[11][l] * w79;
    const double w81 = w78 + w80;
    const double w82 = lane_min(w81, w[31][l]);
    const double w83 = lane_max(w[42][l], w82);
    const double w84 = (-100000.0) * w83;
    const double w85 = w[43][l] + w84;
    const double w86 = lane_max(0.0, w85);
    const double w87 = w86 * w86;
    const double w88 = w86 * w87;
    const double w89 = (-0.5) * w86;
    const double w90 = w89 + 1.0;
    const double w91 = w88 * w90;
    const double w92 = 100000.0 * w83;
    const double w93 = w[43][l] + w92;
    const double w94 = lane_max(0.0, w93);
    const double w95 = w94 * w94;
    const double w96 = w94 * w95;
    const double w97 = (-0.5) * w94;
    const double w98 = w97 + 1.0;
    const double w99 = w96 * w98;
    const double w100 = 1e-05 * w91;
    const double w101 = w83 + w100;
    const double w102 = (-1e-05) * w99;
    const double w103 = w101 + w102;
    const double w104 = w[9][l] * w103;
    const double w105 = w104 * w[10][l];
    const double w106 = c[78][l] * w105;
    const double w107 = w[44][l] + w106;
    const double w108 = lane_sin(w[56][l]);
    const double w109 = w108 * w[57][l];
    const double w110 = w109 * w[49][l];
    const double w111 = c[23][l] * w110;
    const double w112 = lane_min(w111, w[51][l]);
    const double w113 = lane_max(w[58][l], w112);
    const double w114 = (-100000.0) * w113;
    const double w115 = w[59][l] + w114;
    const double w116 = lane_max(0.0, w115);
    const double w117 = w116 * w116;
    const double w118 = w116 * w117;
    const double w119 = (-0.5) * w116;
    const double w120 = w119 + 1.0;
    const double w121 = w118 * w120;
    const double w122 = 100000.0 * w113;
    const double w123 = w[59][l] + w122;
    const double w124 = lane_max(0.0, w123);
    const double w125 = w124 * w124;
    const double w126 = w124 * w125;
    const double w127 = (-0.5) * w124;
    const double w128 = w127 + 1.0;
    const double w129 = w126 * w128;
    const double w130 = 1e-05 * w121;
    const double w131 = w113 + w130;
    const double w132 = (-1e-05) * w129;
    const double w133 = w131 + w132;
    const double w134 = w[45][l] * w133;
    const double w135 = w134 * w[46][l];
    const double w136 = w135 * w[48][l];
    const double w137 = c[91][l] * w53;
    const double w138 = w[61][l] + w137;
    const double w139 = c[92][l] * w107;
    const double w140 = w138 + w139;
    const double w141 = c[93][l] * w136;
    const double w142 = w140 + w141;
    const double w143 = c[70][l] * w51;
    const double w144 = w[66][l] + w143;
    const double w145 = c[107][l] * w105;
    const double w146 = w[67][l] + w145;
    const double w147 = w135 * w[47][l];
    const double w148 = c[87][l] * w147;
    const double w149 = w[68][l] + w148;
    const double w150 = c[92][l] * w144;
    const double w151 = w[70][l] + w150;
    const double w152 = c[91][l] * w146;
    const double w153 = w151 + w152;
    const double w154 = c[92][l] * w149;
    const double w155 = w153 + w154;
    const double w156 = c[118][l] * w53;
    const double w157 = w[73][l] + w156;
    const double w158 = c[118][l] * w107;
    const double w159 = w157 + w158;
    const double w160 = c[119][l] * w144;
    const double w161 = w159 + w160;
    const double w162 = c[120][l] * w146;
    const double w163 = w161 + w162;
    const double w164 = c[121][l] * w149;
    const double w165 = w163 + w164;
    const double w166 = w28 <= w[25][l] ? 1.0 : 0.0;
    const double w167 = w[25][l] <= w28 ? 1.0 : 0.0;
    const double w168 = w166 + w167;
    const double w169 = 1.0 / w168;
    const double w170 = w166 * w169;
    const double w171 = w167 * w169;
    const double w172 = w27 <= w[14][l] ? 1.0 : 0.0;
    const double w173 = w[14][l] <= w27 ? 1.0 : 0.0;
    const double w174 = w172 + w173;
    const double w175 = 1.0 / w174;
    const double w176 = w172 * w175;
    const double w177 = 0.0 <= w9 ? 1.0 : 0.0;
    const double w178 = w9 <= 0.0 ? 1.0 : 0.0;
    const double w179 = w177 + w178;
    const double w180 = 1.0 / w179;
    const double w181 = w177 * w180;
    const double w182 = w8 <= 1.0 ? 1.0 : 0.0;
    const double w183 = 1.0 <= w8 ? 1.0 : 0.0;
    const double w184 = w182 + w183;
    const double w185 = 1.0 / w184;
    const double w186 = w182 * w185;
    const double w187 = lane_cos(w[19][l]);
    const double w188 = w3 * w[21][l];
    const double w189 = w6 * w[22][l];
    const double w190 = 0.0 <= w19 ? 1.0 : 0.0;
    const double w191 = w19 <= 0.0 ? 1.0 : 0.0;
    const double w192 = w190 + w191;
    const double w193 = 1.0 / w192;
    const double w194 = w190 * w193;
    const double w195 = w24 * w[12][l];
    const double w196 = w25 * w[12][l];
    const double w197 = w173 * w175;
    const double w198 = 0.0 <= w31 ? 1.0 : 0.0;
    const double w199 = w31 <= 0.0 ? 1.0 : 0.0;
    const double w200 = w198 + w199;
    const double w201 = 1.0 / w200;
    const double w202 = w198 * w201;
    const double w203 = 0.0 <= w39 ? 1.0 : 0.0;
    const double w204 = w39 <= 0.0 ? 1.0 : 0.0;
    const double w205 = w203 + w204;
    const double w206 = 1.0 / w205;
    const double w207 = w203 * w206;
    const double w208 = w82 <= w[42][l] ? 1.0 : 0.0;
    const double w209 = w[42][l] <= w82 ? 1.0 : 0.0;
    const double w210 = w208 + w209;
    const double w211 = 1.0 / w210;
    const double w212 = w208 * w211;
    const double w213 = w209 * w211;
    const double w214 = w81 <= w[31][l] ? 1.0 : 0.0;
    const double w215 = w[31][l] <= w81 ? 1.0 : 0.0;
    const double w216 = w214 + w215;
    const double w217 = 1.0 / w216;
    const double w218 = w214 * w217;
    const double w219 = 0.0 <= w63 ? 1.0 : 0.0;
    const double w220 = w63 <= 0.0 ? 1.0 : 0.0;
    const double w221 = w219 + w220;
    const double w222 = 1.0 / w221;
    const double w223 = w219 * w222;
    const double w224 = w62 <= 1.0 ? 1.0 : 0.0;
    const double w225 = 1.0 <= w62 ? 1.0 : 0.0;
    const double w226 = w224 + w225;
    const double w227 = 1.0 / w226;
    const double w228 = w224 * w227;
    const double w229 = lane_cos(w[36][l]);
    const double w230 = w57 * w[38][l];
    const double w231 = w60 * w[39][l];
    const double w232 = 0.0 <= w73 ? 1.0 : 0.0;
    const double w233 = w73 <= 0.0 ? 1.0 : 0.0;
    const double w234 = w232 + w233;
    const double w235 = 1.0 / w234;
    const double w236 = w232 * w235;
    const double w237 = w78 * w[29][l];
    const double w238 = w79 * w[29][l];
    const double w239 = w215 * w217;
    const double w240 = 0.0 <= w85 ? 1.0 : 0.0;
    const double w241 = w85 <= 0.0 ? 1.0 : 0.0;
    const double w242 = w240 + w241;
    const double w243 = 1.0 / w242;
    const double w244 = w240 * w243;
    const double w245 = 0.0 <= w93 ? 1.0 : 0.0;
    const double w246 = w93 <= 0.0 ? 1.0 : 0.0;
    const double w247 = w245 + w246;
    const double w248 = 1.0 / w247;
    const double w249 = w245 * w248;
    const double w250 = w112 <= w[58][l] ? 1.0 : 0.0;
    const double w251 = w[58][l] <= w112 ? 1.0 : 0.0;
    const double w252 = w250 + w251;
    const double w253 = 1.0 / w252;
    const double w254 = w250 * w253;
    const double w255 = w251 * w253;
    const double w256 = w111 <= w[51][l] ? 1.0 : 0.0;
    const double w257 = w[51][l] <= w111 ? 1.0 : 0.0;
    const double w258 = w256 + w257;
    const double w259 = 1.0 / w258;
    const double w260 = w256 * w259;
    const double w261 = lane_cos(w[56][l]);
    const double w262 = w110 * w[49][l];
    const double w263 = w257 * w259;
    const double w264 = 0.0 <= w115 ? 1.0 : 0.0;
    const double w265 = w115 <= 0.0 ? 1.0 : 0.0;
    const double w266 = w264 + w265;
    const double w267 = 1.0 / w266;
    const double w268 = w264 * w267;
    const double w269 = 0.0 <= w123 ? 1.0 : 0.0;
    const double w270 = w123 <= 0.0 ? 1.0 : 0.0;
    const double w271 = w269 + w270;
    const double w272 = 1.0 / w271;
    const double w273 = w269 * w272;
    const double w274 = w170 * w[83][l];
    const double w275 = w187 * w[86][l];
    const double w276 = w[20][l] * w275;
    const double w277 = w0 * w[87][l];
    const double w278 = c[145][l] * w276;
    const double w279 = c[146][l] * w277;
    const double w280 = w278 + w279;
    const double w281 = w[11][l] * w280;
    const double w282 = c[186][l] * w1;
    const double w283 = w282 + w281;
    const double w284 = w283 * w[21][l];
    const double w285 = w188 * w[80][l];
    const double w286 = c[147][l] * w285;
    const double w287 = w284 + w286;
    const double w288 = w287 * w[22][l];
    const double w289 = w189 * w[88][l];
    const double w290 = w288 + w289;
    const double w291 = w186 * w290;
    const double w292 = w181 * w291;
    const double w293 = w10 * w292;
    const double w294 = 400.0 * w292;
    const double w295 = (-300.0) * w293;
    const double w296 = w294 + w295;
    const double w297 = w12 * w296;
    const double w298 = w11 * w292;
    const double w299 = w10 * w293;
    const double w300 = 50.0 * w298;
    const double w301 = 100.0 * w299;
    const double w302 = w300 + w301;
    const double w303 = w16 * w302;
    const double w304 = w194 * w290;
    const double w305 = 0.02 * w297;
    const double w306 = (-0.02) * w303;
    const double w307 = w305 + w306;
    const double w308 = -w304;
    const double w309 = w307 + w308;
    const double w310 = w[11][l] * w309;
    const double w311 = c[61][l] * w22;
    const double w312 = w311 + w310;
    const double w313 = w312 * w[12][l];
    const double w314 = w195 * w[81][l];
    const double w315 = w280 * w[12][l];
    const double w316 = w196 * w[81][l];
    const double w317 = (-0.5) * w314;
    const double w318 = w313 + w317;
    const double w319 = w318 + w315;
    const double w320 = c[148][l] * w316;
    const double w321 = w319 + w320;
    const double w322 = w176 * w321;
    const double w323 = w197 * w[83][l];
    const double w324 = -w323;
    const double w325 = w322 + w324;
    const double w326 = w171 * w325;
    const double w327 = w274 + w326;
    const double w328 = 100000.0 * w327;
    const double w329 = w[89][l] + w328;
    const double w330 = w202 * w329;
    const double w331 = w34 * w330;
    const double w332 = w33 * w330;
    const double w333 = w32 * w330;
    const double w334 = w32 * w333;
    const double w335 = 2.0 * w334;
    const double w336 = w332 + w335;
    const double w337 = w36 * w336;
    const double w338 = w[90][l] + w328;
    const double w339 = w207 * w338;
    const double w340 = w41 * w339;
    const double w341 = w40 * w339;
    const double w342 = w40 * w341;
    const double w343 = 2.0 * w342;
    const double w344 = w340 + w343;
    const double w345 = w44 * w344;
    const double w346 = w42 * w339;
    const double w347 = 5e-06 * w331;
    const double w348 = w327 + w347;
    const double w349 = (-1e-05) * w337;
    const double w350 = w348 + w349;
    const double w351 = (-1e-05) * w345;
    const double w352 = w350 + w351;
    const double w353 = 5e-06 * w346;
    const double w354 = w352 + w353;
    const double w355 = w[9][l] * w354;
    const double w356 = w49 * w[78][l];
    const double w357 = c[53][l] * w356;
    const double w358 = w355 + w357;
    const double w359 = w[10][l] * w358;
    const double w360 = w50 * w[79][l];
    const double w361 = w212 * w[94][l];
    const double w362 = w229 * w[97][l];
    const double w363 = w[37][l] * w362;
    const double w364 = w54 * w[98][l];
    const double w365 = c[145][l] * w363;
    const double w366 = c[146][l] * w364;
    const double w367 = w365 + w366;
    const double w368 = w[28][l] * w367;
    const double w369 = c[185][l] * w55;
    const double w370 = w369 + w368;
    const double w371 = w370 * w[38][l];
    const double w372 = w230 * w[91][l];
    const double w373 = c[147][l] * w372;
    const double w374 = w371 + w373;
    const double w375 = w374 * w[39][l];
    const double w376 = w231 * w[99][l];
    const double w377 = -w376;
    const double w378 = w375 + w377;
    const double w379 = w228 * w378;
    const double w380 = w223 * w379;
    const double w381 = w64 * w380;
    const double w382 = 400.0 * w380;
    const double w383 = (-300.0) * w381;
    const double w384 = w382 + w383;
    const double w385 = w66 * w384;
    const double w386 = w65 * w380;
    const double w387 = w64 * w381;
    const double w388 = 50.0 * w386;
    const double w389 = 100.0 * w387;
    const double w390 = w388 + w389;
    const double w391 = w70 * w390;
    const double w392 = w236 * w378;
    const double w393 = 0.02 * w385;
    const double w394 = (-0.02) * w391;
    const double w395 = w393 + w394;
    const double w396 = -w392;
    const double w397 = w395 + w396;
    const double w398 = w[28][l] * w397;
    const double w399 = c[56][l] * w76;
    const double w400 = w399 + w398;
    const double w401 = w400 * w[29][l];
    const double w402 = w237 * w[92][l];
    const double w403 = w367 * w[29][l];
    const double w404 = w238 * w[92][l];
    const double w405 = (-0.5) * w402;
    const double w406 = w401 + w405;
    const double w407 = w406 + w403;
    const double w408 = c[148][l] * w404;
    const double w409 = w407 + w408;
    const double w410 = w218 * w409;
    const double w411 = w239 * w[94][l];
    const double w412 = -w411;
    const double w413 = w410 + w412;
    const double w414 = w213 * w413;
    const double w415 = w361 + w414;
    const double w416 = 100000.0 * w415;
    const double w417 = w[100][l] + w416;
    const double w418 = w244 * w417;
    const double w419 = w88 * w418;
    const double w420 = w87 * w418;
    const double w421 = w86 * w418;
    const double w422 = w86 * w421;
    const double w423 = 2.0 * w422;
    const double w424 = w420 + w423;
    const double w425 = w90 * w424;
    const double w426 = w[101][l] + w416;
    const double w427 = w249 * w426;
    const double w428 = w95 * w427;
    const double w429 = w94 * w427;
    const double w430 = w94 * w429;
    const double w431 = 2.0 * w430;
    const double w432 = w428 + w431;
    const double w433 = w98 * w432;
    const double w434 = w96 * w427;
    const double w435 = 5e-06 * w419;
    const double w436 = w415 + w435;
    const double w437 = (-1e-05) * w425;
    const double w438 = w436 + w437;
    const double w439 = (-1e-05) * w433;
    const double w440 = w438 + w439;
    const double w441 = 5e-06 * w434;
    const double w442 = w440 + w441;
    const double w443 = w[9][l] * w442;
    const double w444 = w103 * w[78][l];
    const double w445 = c[53][l] * w444;
    const double w446 = w443 + w445;
    const double w447 = w[10][l] * w446;
    const double w448 = w104 * w[79][l];
    const double w449 = w133 * w[102][l];
    const double w450 = w254 * w[106][l];
    const double w451 = w261 * w[109][l];
    const double w452 = w[57][l] * w451;
    const double w453 = w108 * w[110][l];
    const double w454 = c[163][l] * w452;
    const double w455 = c[164][l] * w453;
    const double w456 = w454 + w455;
    const double w457 = w456 * w[49][l];
    const double w458 = w262 * w[104][l];
    const double w459 = c[165][l] * w458;
    const double w460 = w457 + w459;
    const double w461 = w260 * w460;
    const double w462 = w263 * w[106][l];
    const double w463 = -w462;
    const double w464 = w461 + w463;
    const double w465 = w255 * w464;
    const double w466 = w450 + w465;
    const double w467 = 100000.0 * w466;
    const double w468 = w[111][l] + w467;
    const double w469 = w268 * w468;
    const double w470 = w118 * w469;
    const double w471 = w117 * w469;
    const double w472 = w116 * w469;
    const double w473 = w116 * w472;
    const double w474 = 2.0 * w473;
    const double w475 = w471 + w474;
    const double w476 = w120 * w475;
    const double w477 = w[112][l] + w467;
    const double w478 = w273 * w477;
    const double w479 = w125 * w478;
    const double w480 = w124 * w478;
    const double w481 = w124 * w480;
    const double w482 = 2.0 * w481;
    const double w483 = w479 + w482;
    const double w484 = w128 * w483;
    const double w485 = w126 * w478;
    const double w486 = 5e-06 * w470;
    const double w487 = w466 + w486;
    const double w488 = (-1e-05) * w476;
    const double w489 = w487 + w488;
    const double w490 = (-1e-05) * w484;
    const double w491 = w489 + w490;
    const double w492 = 5e-06 * w485;
    const double w493 = w491 + w492;
    const double w494 = w[45][l] * w493;
    const double w495 = c[52][l] * w449;
    const double w496 = w495 + w494;
    const double w497 = w[46][l] * w496;
    const double w498 = w134 * w[103][l];
    const double w499 = c[20][l] * w497;
    const double w500 = c[154][l] * w498;
    const double w501 = w499 + w500;
    const double w502 = w[48][l] * w501;
    const double w503 = w170 * w[119][l];
    const double w504 = w187 * w[122][l];
    const double w505 = w[20][l] * w504;
    const double w506 = w0 * w[123][l];
    const double w507 = c[145][l] * w505;
    const double w508 = c[146][l] * w506;
    const double w509 = w507 + w508;
    const double w510 = w[11][l] * w509;
    const double w511 = c[191][l] * w1;
    const double w512 = w511 + w510;
    const double w513 = w512 * w[21][l];
    const double w514 = w188 * w[116][l];
    const double w515 = c[147][l] * w514;
    const double w516 = w513 + w515;
    const double w517 = w516 * w[22][l];
    const double w518 = w189 * w[124][l];
    const double w519 = -w518;
    const double w520 = w517 + w519;
    const double w521 = w186 * w520;
    const double w522 = w181 * w521;
    const double w523 = w10 * w522;
    const double w524 = 400.0 * w522;
    const double w525 = (-300.0) * w523;
    const double w526 = w524 + w525;
    const double w527 = w12 * w526;
    const double w528 = w11 * w522;
    const double w529 = w10 * w523;
    const double w530 = 50.0 * w528;
    const double w531 = 100.0 * w529;
    const double w532 = w530 + w531;
    const double w533 = w16 * w532;
    const double w534 = w194 * w520;
    const double w535 = 0.02 * w527;
    const double w536 = (-0.02) * w533;
    const double w537 = w535 + w536;
    const double w538 = -w534;
    const double w539 = w537 + w538;
    const double w540 = w[11][l] * w539;
    const double w541 = c[58][l] * w22;
    const double w542 = w541 + w540;
    const double w543 = w542 * w[12][l];
    const double w544 = w195 * w[117][l];
    const double w545 = w509 * w[12][l];
    const double w546 = w196 * w[117][l];
    const double w547 = (-0.5) * w544;
    const double w548 = w543 + w547;
    const double w549 = w548 + w545;
    const double w550 = c[148][l] * w546;
    const double w551 = w549 + w550;
    const double w552 = w176 * w551;
    const double w553 = w197 * w[119][l];
    const double w554 = -w553;
    const double w555 = w552 + w554;
    const double w556 = w171 * w555;
    const double w557 = w503 + w556;
    const double w558 = 100000.0 * w557;
    const double w559 = w[125][l] + w558;
    const double w560 = w202 * w559;
    const double w561 = w34 * w560;
    const double w562 = w33 * w560;
    const double w563 = w32 * w560;
    const double w564 = w32 * w563;
    const double w565 = 2.0 * w564;
    const double w566 = w562 + w565;
    const double w567 = w36 * w566;
    const double w568 = w[126][l] + w558;
    const double w569 = w207 * w568;
    const double w570 = w41 * w569;
    const double w571 = w40 * w569;
    const double w572 = w40 * w571;
    const double w573 = 2.0 * w572;
    const double w574 = w570 + w573;
    const double w575 = w44 * w574;
    const double w576 = w42 * w569;
    const double w577 = 5e-06 * w561;
    const double w578 = w557 + w577;
    const double w579 = (-1e-05) * w567;
    const double w580 = w578 + w579;
    const double w581 = (-1e-05) * w575;
    const double w582 = w580 + w581;
    const double w583 = 5e-06 * w576;
    const double w584 = w582 + w583;
    const double w585 = w[9][l] * w584;
    const double w586 = w49 * w[114][l];
    const double w587 = c[53][l] * w586;
    const double w588 = w585 + w587;
    const double w589 = w[10][l] * w588;
    const double w590 = w50 * w[115][l];
    const double w591 = w212 * w[130][l];
    const double w592 = w229 * w[133][l];
    const double w593 = w[37][l] * w592;
    const double w594 = w54 * w[134][l];
    const double w595 = c[145][l] * w593;
    const double w596 = c[146][l] * w594;
    const double w597 = w595 + w596;
    const double w598 = w[28][l] * w597;
    const double w599 = c[191][l] * w55;
    const double w600 = w599 + w598;
    const double w601 = w600 * w[38][l];
    const double w602 = w230 * w[127][l];
    const double w603 = c[147][l] * w602;
    const double w604 = w601 + w603;
    const double w605 = w604 * w[39][l];
    const double w606 = w231 * w[135][l];
    const double w607 = -w606;
    const double w608 = w605 + w607;
    const double w609 = w228 * w608;
    const double w610 = w223 * w609;
    const double w611 = w64 * w610;
    const double w612 = 400.0 * w610;
    const double w613 = (-300.0) * w611;
    const double w614 = w612 + w613;
    const double w615 = w66 * w614;
    const double w616 = w65 * w610;
    const double w617 = w64 * w611;
    const double w618 = 50.0 * w616;
    const double w619 = 100.0 * w617;
    const double w620 = w618 + w619;
    const double w621 = w70 * w620;
    const double w622 = w236 * w608;
    const double w623 = 0.02 * w615;
    const double w624 = (-0.02) * w621;
    const double w625 = w623 + w624;
    const double w626 = -w622;
    const double w627 = w625 + w626;
    const double w628 = w[28][l] * w627;
    const double w629 = c[58][l] * w76;
    const double w630 = w629 + w628;
    const double w631 = w630 * w[29][l];
    const double w632 = w237 * w[128][l];
    const double w633 = w597 * w[29][l];
    const double w634 = w238 * w[128][l];
    const double w635 = (-0.5) * w632;
    const double w636 = w631 + w635;
    const double w637 = w636 + w633;
    const double w638 = c[148][l] * w634;
    const double w639 = w637 + w638;
    const double w640 = w218 * w639;
    const double w641 = w239 * w[130][l];
    const double w642 = -w641;
    const double w643 = w640 + w642;
    const double w644 = w213 * w643;
    const double w645 = w591 + w644;
    const double w646 = 100000.0 * w645;
    const double w647 = w[136][l] + w646;
    const double w648 = w244 * w647;
    const double w649 = w88 * w648;
    const double w650 = w87 * w648;
    const double w651 = w86 * w648;
    const double w652 = w86 * w651;
    const double w653 = 2.0 * w652;
    const double w654 = w650 + w653;
    const double w655 = w90 * w654;
    const double w656 = w[137][l] + w646;
    const double w657 = w249 * w656;
    const double w658 = w95 * w657;
    const double w659 = w94 * w657;
    const double w660 = w94 * w659;
    const double w661 = 2.0 * w660;
    const double w662 = w658 + w661;
    const double w663 = w98 * w662;
    const double w664 = w96 * w657;
    const double w665 = 5e-06 * w649;
    const double w666 = w645 + w665;
    const double w667 = (-1e-05) * w655;
    const double w668 = w666 + w667;
    const double w669 = (-1e-05) * w663;
    const double w670 = w668 + w669;
    const double w671 = 5e-06 * w664;
    const double w672 = w670 + w671;
    const double w673 = w[9][l] * w672;
    const double w674 = w103 * w[114][l];
    const double w675 = c[53][l] * w674;
    const double w676 = w673 + w675;
    const double w677 = w[10][l] * w676;
    const double w678 = w104 * w[115][l];
    const double w679 = w133 * w[139][l];
    const double w680 = w254 * w[144][l];
    const double w681 = w261 * w[147][l];
    const double w682 = w[57][l] * w681;
    const double w683 = w108 * w[148][l];
    const double w684 = c[163][l] * w682;
    const double w685 = c[164][l] * w683;
    const double w686 = w684 + w685;
    const double w687 = w686 * w[49][l];
    const double w688 = w262 * w[141][l];
    const double w689 = c[165][l] * w688;
    const double w690 = w687 + w689;
    const double w691 = w260 * w690;
    const double w692 = w263 * w[144][l];
    const double w693 = -w692;
    const double w694 = w691 + w693;
    const double w695 = w255 * w694;
    const double w696 = w680 + w695;
    const double w697 = 100000.0 * w696;
    const double w698 = w[149][l] + w697;
    const double w699 = w268 * w698;
    const double w700 = w118 * w699;
    const double w701 = w117 * w699;
    const double w702 = w116 * w699;
    const double w703 = w116 * w702;
    const double w704 = 2.0 * w703;
    const double w705 = w701 + w704;
    const double w706 = w120 * w705;
    const double w707 = w[150][l] + w697;
    const double w708 = w273 * w707;
    const double w709 = w125 * w708;
    const double w710 = w124 * w708;
    const double w711 = w124 * w710;
    const double w712 = 2.0 * w711;
    const double w713 = w709 + w712;
    const double w714 = w128 * w713;
    const double w715 = w126 * w708;
    const double w716 = 5e-06 * w700;
    const double w717 = w696 + w716;
    const double w718 = (-1e-05) * w706;
    const double w719 = w717 + w718;
    const double w720 = (-1e-05) * w714;
    const double w721 = w719 + w720;
    const double w722 = 5e-06 * w715;
    const double w723 = w721 + w722;
    const double w724 = w[45][l] * w723;
    const double w725 = c[52][l] * w679;
    const double w726 = w725 + w724;
    const double w727 = w[46][l] * w726;
    const double w728 = w134 * w[140][l];
    const double w729 = c[20][l] * w727;
    const double w730 = c[154][l] * w728;
    const double w731 = w729 + w730;
    const double w732 = w[47][l] * w731;
    const double w733 = w170 * w[154][l];
    const double w734 = w187 * w[157][l];
    const double w735 = w[20][l] * w734;
    const double w736 = w0 * w[158][l];
    const double w737 = c[145][l] * w735;
    const double w738 = c[146][l] * w736;
    const double w739 = w737 + w738;
    const double w740 = w[11][l] * w739;
    const double w741 = c[223][l] * w1;
    const double w742 = w741 + w740;
    const double w743 = w742 * w[21][l];
    const double w744 = w188 * w[151][l];
    const double w745 = c[147][l] * w744;
    const double w746 = w743 + w745;
    const double w747 = w746 * w[22][l];
    const double w748 = w189 * w[159][l];
    const double w749 = -w748;
    const double w750 = w747 + w749;
    const double w751 = w186 * w750;
    const double w752 = w181 * w751;
    const double w753 = w10 * w752;
    const double w754 = 400.0 * w752;
    const double w755 = (-300.0) * w753;
    const double w756 = w754 + w755;
    const double w757 = w12 * w756;
    const double w758 = w11 * w752;
    const double w759 = w10 * w753;
    const double w760 = 50.0 * w758;
    const double w761 = 100.0 * w759;
    const double w762 = w760 + w761;
    const double w763 = w16 * w762;
    const double w764 = w194 * w750;
    const double w765 = 0.02 * w757;
    const double w766 = (-0.02) * w763;
    const double w767 = w765 + w766;
    const double w768 = -w764;
    const double w769 = w767 + w768;
    const double w770 = w[11][l] * w769;
    const double w771 = c[221][l] * w22;
    const double w772 = w771 + w770;
    const double w773 = w772 * w[12][l];
    const double w774 = w195 * w[152][l];
    const double w775 = w739 * w[12][l];
    const double w776 = w196 * w[152][l];
    const double w777 = (-0.5) * w774;
    const double w778 = w773 + w777;
    const double w779 = w778 + w775;
    const double w780 = c[148][l] * w776;
    const double w781 = w779 + w780;
    const double w782 = w176 * w781;
    const double w783 = w197 * w[154][l];
    const double w784 = -w783;
    const double w785 = w782 + w784;
    const double w786 = w171 * w785;
    const double w787 = w733 + w786;
    const double w788 = 100000.0 * w787;
    const double w789 = w[160][l] + w788;
    const double w790 = w202 * w789;
    const double w791 = w34 * w790;
    const double w792 = w33 * w790;
    const double w793 = w32 * w790;
    const double w794 = w32 * w793;
    const double w795 = 2.0 * w794;
    const double w796 = w792 + w795;
    const double w797 = w36 * w796;
    const double w798 = w[161][l] + w788;
    const double w799 = w207 * w798;
    const double w800 = w41 * w799;
    const double w801 = w40 * w799;
    const double w802 = w40 * w801;
    const double w803 = 2.0 * w802;
    const double w804 = w800 + w803;
    const double w805 = w44 * w804;
    const double w806 = w42 * w799;
    const double w807 = 5e-06 * w791;
    const double w808 = w787 + w807;
    const double w809 = (-1e-05) * w797;
    const double w810 = w808 + w809;
    const double w811 = (-1e-05) * w805;
    const double w812 = w810 + w811;
    const double w813 = 5e-06 * w806;
    const double w814 = w812 + w813;
    const double w815 = w[9][l] * w814;
    const double w816 = w[10][l] * w815;
    const double w817 = w212 * w[165][l];
    const double w818 = w229 * w[168][l];
    const double w819 = w[37][l] * w818;
    const double w820 = w54 * w[169][l];
    const double w821 = c[145][l] * w819;
    const double w822 = c[146][l] * w820;
    const double w823 = w821 + w822;
    const double w824 = w[28][l] * w823;
    const double w825 = c[223][l] * w55;
    const double w826 = w825 + w824;
    const double w827 = w826 * w[38][l];
    const double w828 = w230 * w[162][l];
    const double w829 = c[147][l] * w828;
    const double w830 = w827 + w829;
    const double w831 = w830 * w[39][l];
    const double w832 = w231 * w[170][l];
    const double w833 = -w832;
    const double w834 = w831 + w833;
    const double w835 = w228 * w834;
    const double w836 = w223 * w835;
    const double w837 = w64 * w836;
    const double w838 = 400.0 * w836;
    const double w839 = (-300.0) * w837;
    const double w840 = w838 + w839;
    const double w841 = w66 * w840;
    const double w842 = w65 * w836;
    const double w843 = w64 * w837;
    const double w844 = 50.0 * w842;
    const double w845 = 100.0 * w843;
    const double w846 = w844 + w845;
    const double w847 = w70 * w846;
    const double w848 = w236 * w834;
    const double w849 = 0.02 * w841;
    const double w850 = (-0.02) * w847;
    const double w851 = w849 + w850;
    const double w852 = -w848;
    const double w853 = w851 + w852;
    const double w854 = w[28][l] * w853;
    const double w855 = c[221][l] * w76;
    const double w856 = w855 + w854;
    const double w857 = w856 * w[29][l];
    const double w858 = w237 * w[163][l];
    const double w859 = w823 * w[29][l];
    const double w860 = w238 * w[163][l];
    const double w861 = (-0.5) * w858;
    const double w862 = w857 + w861;
    const double w863 = w862 + w859;
    const double w864 = c[148][l] * w860;
    const double w865 = w863 + w864;
    const double w866 = w218 * w865;
    const double w867 = w239 * w[165][l];
    const double w868 = -w867;
    const double w869 = w866 + w868;
    const double w870 = w213 * w869;
    const double w871 = w817 + w870;
    const double w872 = 100000.0 * w871;
    const double w873 = w[171][l] + w872;
    const double w874 = w244 * w873;
    const double w875 = w88 * w874;
    const double w876 = w87 * w874;
    const double w877 = w86 * w874;
    const double w878 = w86 * w877;
    const double w879 = 2.0 * w878;
    const double w880 = w876 + w879;
    const double w881 = w90 * w880;
    const double w882 = w[172][l] + w872;
    const double w883 = w249 * w882;
    const double w884 = w95 * w883;
    const double w885 = w94 * w883;
    const double w886 = w94 * w885;
    const double w887 = 2.0 * w886;
    const double w888 = w884 + w887;
    const double w889 = w98 * w888;
    const double w890 = w96 * w883;
    const double w891 = 5e-06 * w875;
    const double w892 = w871 + w891;
    const double w893 = (-1e-05) * w881;
    const double w894 = w892 + w893;
    const double w895 = (-1e-05) * w889;
    const double w896 = w894 + w895;
    const double w897 = 5e-06 * w890;
    const double w898 = w896 + w897;
    const double w899 = w[9][l] * w898;
    const double w900 = w[10][l] * w899;
    const double w901 = w254 * w[175][l];
    const double w902 = w261 * w[178][l];
    const double w903 = w[57][l] * w902;
    const double w904 = w108 * w[179][l];
    const double w905 = c[163][l] * w903;
    const double w906 = c[164][l] * w904;
    const double w907 = w905 + w906;
    const double w908 = w907 * w[49][l];
    const double w909 = w262 * w[173][l];
    const double w910 = c[165][l] * w909;
    const double w911 = w908 + w910;
    const double w912 = w260 * w911;
    const double w913 = w263 * w[175][l];
    const double w914 = -w913;
    const double w915 = w912 + w914;
    const double w916 = w255 * w915;
    const double w917 = w901 + w916;
    const double w918 = 100000.0 * w917;
    const double w919 = w[180][l] + w918;
    const double w920 = w268 * w919;
    const double w921 = w118 * w920;
    const double w922 = w117 * w920;
    const double w923 = w116 * w920;
    const double w924 = w116 * w923;
    const double w925 = 2.0 * w924;
    const double w926 = w922 + w925;
    const double w927 = w120 * w926;
    const double w928 = w[181][l] + w918;
    const double w929 = w273 * w928;
    const double w930 = w125 * w929;
    const double w931 = w124 * w929;
    const double w932 = w124 * w931;
    const double w933 = 2.0 * w932;
    const double w934 = w930 + w933;
    const double w935 = w128 * w934;
    const double w936 = w126 * w929;
    const double w937 = 5e-06 * w921;
    const double w938 = w917 + w937;
    const double w939 = (-1e-05) * w927;
    const double w940 = w938 + w939;
    const double w941 = (-1e-05) * w935;
    const double w942 = w940 + w941;
    const double w943 = 5e-06 * w936;
    const double w944 = w942 + w943;
    const double w945 = w[45][l] * w944;
    const double w946 = w[46][l] * w945;
    const double w947 = w[47][l] * w946;
    const double w948 = c[166][l] * w502;
    const double w949 = c[8][l] * w359;
    const double w950 = c[149][l] * w360;
    const double w951 = w949 + w950;
    const double w952 = c[56][l] * w951;
    const double w953 = w[183][l] + w952;
    const double w954 = c[13][l] * w447;
    const double w955 = c[153][l] * w448;
    const double w956 = w954 + w955;
    const double w957 = c[56][l] * w956;
    const double w958 = w[184][l] + w957;
    const double w959 = w[186][l] + w948;
    const double w960 = c[91][l] * w953;
    const double w961 = w959 + w960;
    const double w962 = c[92][l] * w958;
    const double w963 = w961 + w962;
    const double w964 = c[58][l] * w951;
    const double w965 = w[188][l] + w964;
    const double w966 = c[150][l] * w956;
    const double w967 = w[189][l] + w966;
    const double w968 = w[47][l] * w501;
    const double w969 = c[81][l] * w968;
    const double w970 = w[190][l] + w969;
    const double w971 = c[92][l] * w965;
    const double w972 = w[192][l] + w971;
    const double w973 = c[91][l] * w967;
    const double w974 = w972 + w973;
    const double w975 = c[92][l] * w970;
    const double w976 = w974 + w975;
    const double w977 = c[118][l] * w953;
    const double w978 = w[194][l] + w977;
    const double w979 = c[118][l] * w958;
    const double w980 = w978 + w979;
    const double w981 = c[119][l] * w965;
    const double w982 = w980 + w981;
    const double w983 = c[120][l] * w967;
    const double w984 = w982 + w983;
    const double w985 = c[121][l] * w970;
    const double w986 = w984 + w985;
    const double w987 = c[8][l] * w589;
    const double w988 = c[149][l] * w590;
    const double w989 = w987 + w988;
    const double w990 = c[56][l] * w989;
    const double w991 = w[195][l] + w990;
    const double w992 = c[13][l] * w677;
    const double w993 = c[153][l] * w678;
    const double w994 = w992 + w993;
    const double w995 = c[56][l] * w994;
    const double w996 = w[196][l] + w995;
    const double w997 = w[48][l] * w731;
    const double w998 = c[91][l] * w991;
    const double w999 = w[198][l] + w998;
    const double w1000 = c[92][l] * w996;
    const double w1001 = w999 + w1000;
    const double w1002 = c[166][l] * w997;
    const double w1003 = w1001 + w1002;
    const double w1004 = c[58][l] * w989;
    const double w1005 = w[199][l] + w1004;
    const double w1006 = c[150][l] * w994;
    const double w1007 = w[200][l] + w1006;
    const double w1008 = c[81][l] * w732;
    const double w1009 = w[143][l] + w1008;
    const double w1010 = c[92][l] * w1005;
    const double w1011 = w[202][l] + w1010;
    const double w1012 = c[91][l] * w1007;
    const double w1013 = w1011 + w1012;
    const double w1014 = c[92][l] * w1009;
    const double w1015 = w1013 + w1014;
    const double w1016 = c[118][l] * w991;
    const double w1017 = w[204][l] + w1016;
    const double w1018 = c[118][l] * w996;
    const double w1019 = w1017 + w1018;
    const double w1020 = c[119][l] * w1005;
    const double w1021 = w1019 + w1020;
    const double w1022 = c[120][l] * w1007;
    const double w1023 = w1021 + w1022;
    const double w1024 = c[121][l] * w1009;
    const double w1025 = w1023 + w1024;
    const double w1026 = c[69][l] * w816;
    const double w1027 = w[205][l] + w1026;
    const double w1028 = c[78][l] * w900;
    const double w1029 = w[206][l] + w1028;
    const double w1030 = w[48][l] * w946;
    const double w1031 = c[91][l] * w1027;
    const double w1032 = w[207][l] + w1031;
    const double w1033 = c[92][l] * w1029;
    const double w1034 = w1032 + w1033;
    const double w1035 = c[93][l] * w1030;
    const double w1036 = w1034 + w1035;
    const double w1037 = c[70][l] * w816;
    const double w1038 = w[208][l] + w1037;
    const double w1039 = c[107][l] * w900;
    const double w1040 = w[209][l] + w1039;
    const double w1041 = c[87][l] * w947;
    const double w1042 = w[210][l] + w1041;
    const double w1043 = c[92][l] * w1038;
    const double w1044 = w[212][l] + w1043;
    const double w1045 = c[91][l] * w1040;
    const double w1046 = w1044 + w1045;
    const double w1047 = c[92][l] * w1042;
    const double w1048 = w1046 + w1047;
    const double w1049 = c[118][l] * w1027;
    const double w1050 = w[213][l] + w1049;
    const double w1051 = c[118][l] * w1029;
    const double w1052 = w1050 + w1051;
    const double w1053 = c[119][l] * w1038;
    const double w1054 = w1052 + w1053;
    const double w1055 = c[120][l] * w1040;
    const double w1056 = w1054 + w1055;
    const double w1057 = c[121][l] * w1042;
    const double w1058 = w1056 + w1057;
    const double w1059 = w170 * w[220][l];
    const double w1060 = w187 * w[222][l];
    const double w1061 = w[20][l] * w1060;
    const double w1062 = w[11][l] * w1061;
    const double w1063 = w1062 * w[21][l];
    const double w1064 = w1063 * w[22][l];
    const double w1065 = w186 * w1064;
    const double w1066 = w181 * w1065;
    const double w1067 = w10 * w1066;
    const double w1068 = c[254][l] * w1066;
    const double w1069 = c[256][l] * w1067;
    const double w1070 = w1068 + w1069;
    const double w1071 = w12 * w1070;
    const double w1072 = w11 * w1066;
    const double w1073 = w10 * w1067;
    const double w1074 = c[253][l] * w1072;
    const double w1075 = c[255][l] * w1073;
    const double w1076 = w1074 + w1075;
    const double w1077 = w16 * w1076;
    const double w1078 = w194 * w1064;
    const double w1079 = 0.02 * w1071;
    const double w1080 = (-0.02) * w1077;
    const double w1081 = w1079 + w1080;
    const double w1082 = c[257][l] * w1078;
    const double w1083 = w1081 + w1082;
    const double w1084 = w[11][l] * w1083;
    const double w1085 = w1084 * w[12][l];
    const double w1086 = w1061 * w[12][l];
    const double w1087 = c[145][l] * w1086;
    const double w1088 = w1085 + w1087;
    const double w1089 = w176 * w1088;
    const double w1090 = w197 * w[220][l];
    const double w1091 = -w1090;
    const double w1092 = w1089 + w1091;
    const double w1093 = w171 * w1092;
    const double w1094 = w1059 + w1093;
    const double w1095 = 100000.0 * w1094;
    const double w1096 = w[223][l] + w1095;
    const double w1097 = w202 * w1096;
    const double w1098 = w34 * w1097;
    const double w1099 = w33 * w1097;
    const double w1100 = w32 * w1097;
    const double w1101 = w32 * w1100;
    const double w1102 = 2.0 * w1101;
    const double w1103 = w1099 + w1102;
    const double w1104 = w36 * w1103;
    const double w1105 = w[224][l] + w1095;
    const double w1106 = w207 * w1105;
    const double w1107 = w41 * w1106;
    const double w1108 = w40 * w1106;
    const double w1109 = w40 * w1108;
    const double w1110 = 2.0 * w1109;
    const double w1111 = w1107 + w1110;
    const double w1112 = w44 * w1111;
    const double w1113 = w42 * w1106;
    const double w1114 = 5e-06 * w1098;
    const double w1115 = w1094 + w1114;
    const double w1116 = (-1e-05) * w1104;
    const double w1117 = w1115 + w1116;
    const double w1118 = (-1e-05) * w1112;
    const double w1119 = w1117 + w1118;
    const double w1120 = 5e-06 * w1113;
    const double w1121 = w1119 + w1120;
    const double w1122 = w[9][l] * w1121;
    const double w1123 = w49 * w[218][l];
    const double w1124 = c[53][l] * w1123;
    const double w1125 = w1122 + w1124;
    const double w1126 = w[10][l] * w1125;
    const double w1127 = w50 * w[219][l];
    const double w1128 = c[8][l] * w1126;
    const double w1129 = c[149][l] * w1127;
    const double w1130 = w1128 + w1129;
    const double w1131 = c[56][l] * w1130;
    const double w1132 = w[225][l] + w1131;
    const double w1133 = w212 * w[226][l];
    const double w1134 = w229 * w[228][l];
    const double w1135 = w[37][l] * w1134;
    const double w1136 = w[28][l] * w1135;
    const double w1137 = w1136 * w[38][l];
    const double w1138 = w1137 * w[39][l];
    const double w1139 = w228 * w1138;
    const double w1140 = w223 * w1139;
    const double w1141 = w64 * w1140;
    const double w1142 = c[254][l] * w1140;
    const double w1143 = c[256][l] * w1141;
    const double w1144 = w1142 + w1143;
    const double w1145 = w66 * w1144;
    const double w1146 = w65 * w1140;
    const double w1147 = w64 * w1141;
    const double w1148 = c[253][l] * w1146;
    const double w1149 = c[255][l] * w1147;
    const double w1150 = w1148 + w1149;
    const double w1151 = w70 * w1150;
    const double w1152 = w236 * w1138;
    const double w1153 = 0.02 * w1145;
    const double w1154 = (-0.02) * w1151;
    const double w1155 = w1153 + w1154;
    const double w1156 = c[257][l] * w1152;
    const double w1157 = w1155 + w1156;
    const double w1158 = w[28][l] * w1157;
    const double w1159 = w1158 * w[29][l];
    const double w1160 = w1135 * w[29][l];
    const double w1161 = c[145][l] * w1160;
    const double w1162 = w1159 + w1161;
    const double w1163 = w218 * w1162;
    const double w1164 = w239 * w[226][l];
    const double w1165 = -w1164;
    const double w1166 = w1163 + w1165;
    const double w1167 = w213 * w1166;
    const double w1168 = w1133 + w1167;
    const double w1169 = 100000.0 * w1168;
    const double w1170 = w[229][l] + w1169;
    const double w1171 = w244 * w1170;
    const double w1172 = w88 * w1171;
    const double w1173 = w87 * w1171;
    const double w1174 = w86 * w1171;
    const double w1175 = w86 * w1174;
    const double w1176 = 2.0 * w1175;
    const double w1177 = w1173 + w1176;
    const double w1178 = w90 * w1177;
    const double w1179 = w[230][l] + w1169;
    const double w1180 = w249 * w1179;
    const double w1181 = w95 * w1180;
    const double w1182 = w94 * w1180;
    const double w1183 = w94 * w1182;
    const double w1184 = 2.0 * w1183;
    const double w1185 = w1181 + w1184;
    const double w1186 = w98 * w1185;
    const double w1187 = w96 * w1180;
    const double w1188 = 5e-06 * w1172;
    const double w1189 = w1168 + w1188;
    const double w1190 = (-1e-05) * w1178;
    const double w1191 = w1189 + w1190;
    const double w1192 = (-1e-05) * w1186;
    const double w1193 = w1191 + w1192;
    const double w1194 = 5e-06 * w1187;
    const double w1195 = w1193 + w1194;
    const double w1196 = w[9][l] * w1195;
    const double w1197 = w103 * w[218][l];
    const double w1198 = c[53][l] * w1197;
    const double w1199 = w1196 + w1198;
    const double w1200 = w[10][l] * w1199;
    const double w1201 = w104 * w[219][l];
    const double w1202 = c[13][l] * w1200;
    const double w1203 = c[153][l] * w1201;
    const double w1204 = w1202 + w1203;
    const double w1205 = c[56][l] * w1204;
    const double w1206 = w[231][l] + w1205;
    const double w1207 = w133 * w[232][l];
    const double w1208 = w254 * w[234][l];
    const double w1209 = w261 * w[236][l];
    const double w1210 = w[57][l] * w1209;
    const double w1211 = w1210 * w[49][l];
    const double w1212 = w260 * w1211;
    const double w1213 = w263 * w[234][l];
    const double w1214 = c[163][l] * w1212;
    const double w1215 = -w1213;
    const double w1216 = w1214 + w1215;
    const double w1217 = w255 * w1216;
    const double w1218 = w1208 + w1217;
    const double w1219 = 100000.0 * w1218;
    const double w1220 = w[237][l] + w1219;
    const double w1221 = w268 * w1220;
    const double w1222 = w118 * w1221;
    const double w1223 = w117 * w1221;
    const double w1224 = w116 * w1221;
    const double w1225 = w116 * w1224;
    const double w1226 = 2.0 * w1225;
    const double w1227 = w1223 + w1226;
    const double w1228 = w120 * w1227;
    const double w1229 = w[238][l] + w1219;
    const double w1230 = w273 * w1229;
    const double w1231 = w125 * w1230;
    const double w1232 = w124 * w1230;
    const double w1233 = w124 * w1232;
    const double w1234 = 2.0 * w1233;
    const double w1235 = w1231 + w1234;
    const double w1236 = w128 * w1235;
    const double w1237 = w126 * w1230;
    const double w1238 = 5e-06 * w1222;
    const double w1239 = w1218 + w1238;
    const double w1240 = (-1e-05) * w1228;
    const double w1241 = w1239 + w1240;
    const double w1242 = (-1e-05) * w1236;
    const double w1243 = w1241 + w1242;
    const double w1244 = 5e-06 * w1237;
    const double w1245 = w1243 + w1244;
    const double w1246 = w[45][l] * w1245;
    const double w1247 = c[52][l] * w1207;
    const double w1248 = w1247 + w1246;
    const double w1249 = w[46][l] * w1248;
    const double w1250 = w134 * w[233][l];
    const double w1251 = c[20][l] * w1249;
    const double w1252 = c[154][l] * w1250;
    const double w1253 = w1251 + w1252;
    const double w1254 = w[48][l] * w1253;
    const double w1255 = c[91][l] * w1132;
    const double w1256 = w[240][l] + w1255;
    const double w1257 = c[92][l] * w1206;
    const double w1258 = w1256 + w1257;
    const double w1259 = c[166][l] * w1254;
    const double w1260 = w1258 + w1259;
    const double w1261 = c[58][l] * w1130;
    const double w1262 = w[243][l] + w1261;
    const double w1263 = c[150][l] * w1204;
    const double w1264 = w[244][l] + w1263;
    const double w1265 = w[47][l] * w1253;
    const double w1266 = c[81][l] * w1265;
    const double w1267 = w[245][l] + w1266;
    const double w1268 = c[92][l] * w1262;
    const double w1269 = w[247][l] + w1268;
    const double w1270 = c[91][l] * w1264;
    const double w1271 = w1269 + w1270;
    const double w1272 = c[92][l] * w1267;
    const double w1273 = w1271 + w1272;
    const double w1274 = c[118][l] * w1132;
    const double w1275 = w[249][l] + w1274;
    const double w1276 = c[118][l] * w1206;
    const double w1277 = w1275 + w1276;
    const double w1278 = c[119][l] * w1262;
    const double w1279 = w1277 + w1278;
    const double w1280 = c[120][l] * w1264;
    const double w1281 = w1279 + w1280;
    const double w1282 = c[121][l] * w1267;
    const double w1283 = w1281 + w1282;
    WRITE(f, S0, w142);
    WRITE(f, S1, w155);
    WRITE(f, S2, w165);
    WRITE_ENTRY(J, S0, S0, w963);
    WRITE_ENTRY(J, S1, S0, w976);
    WRITE_ENTRY(J, S2, S0, w986);
    WRITE_ENTRY(J, S0, S1, w1003);
    WRITE_ENTRY(J, S1, S1, w1015);
    WRITE_ENTRY(J, S2, S1, w1025);
    WRITE_ENTRY(J, S0, S2, w1036);
    WRITE_ENTRY(J, S1, S2, w1048);
    WRITE_ENTRY(J, S2, S2, w1058);
    WRITE_ENTRY(J, S0, S5, w1260);
    WRITE_ENTRY(J, S1, S5, w1273);
    WRITE_ENTRY(J, S2, S5, w1283);
}

APART void jacobian(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes (*J)[ND1])
{
    lanes w[250];
    LANE_LOOP entry0(c, u, x, f, J, w, l);
    LANE_LOOP entry1(c, u, x, f, J, w, l);
    LANE_LOOP entry2(c, u, x, f, J, w, l);
    LANE_LOOP entry3(c, u, x, f, J, w, l);
    LANE_LOOP entry4(c, u, x, f, J, w, l);
}
#endif

INLINE void output(const lanes *c, int l, double x0, double x1, double x2, double x4, double x5, double u0, double u1, double u2, double u3, double u4, double u5, double u6, double u7, double u8, double u9, double u10, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10, double *y11, double *y12, double *y13, double *y14, double *y15, double *y16, double *y17, double *y18, double *y19, double *y20, double *y21, double *y22, double *y23, double *y24, double *y25, double *y26, double *y27, double *y28, double *y29, double *y30, double *y31, double *y32, double *y33, double *y34, double *y35, double *y36, double *y37, double *y38)
{
    const double w0 = lane_cos(x5);
    const double w1 = u0 * w0;
    const double w2 = lane_sin(x5);
    const double w3 = u1 * w2;
    const double w4 = w1 + w3;
    const double w5 = -w4;
    const double w6 = x0 + w5;
    const double w7 = w6 * w6;
    const double w8 = w7 + 1e-06;
    const double w9 = sqrt(w8);
    const double w10 = w6 * w9;
    const double w11 = c[36][l] * u2;
    const double w12 = w11 + w10;
    const double w13 = 1000000.0 * w12;
    const double w14 = lane_min(1.0, w13);
    const double w15 = lane_max(0.0, w14);
    const double w16 = w15 * w15;
    const double w17 = w15 * w16;
    const double w18 = (-8.0) * w15;
    const double w19 = w18 + 6.0;
    const double w20 = 3.0 * w16;
    const double w21 = w19 + w20;
    const double w22 = w17 * w21;
    const double w23 = w12 + (-1e-06);
    const double w24 = lane_max(0.0, w23);
    const double w25 = 1e-06 * w22;
    const double w26 = w25 + 1e-06;
    const double w27 = w26 + w24;
    const double w28 = sqrt(w27);
    const double w29 = lane_atan2(0.0, w28);
    const double w30 = c[1][l] * u3;
    const double w31 = w30 + c[37][l];
    const double w32 = c[35][l] * w29;
    const double w33 = w31 + w32;
    const double w34 = c[2][l] * w33;
    const double w35 = lane_min(c[33][l], w34);
    const double w36 = lane_max(c[34][l], w35);
    const double w37 = (-5.0) * w36;
    const double w38 = w37 + c[38][l];
    const double w39 = lane_max(0.0, w38);
    const double w40 = w39 * w39;
    const double w41 = w39 * w40;
    const double w42 = (-0.5) * w39;
    const double w43 = w42 + 1.0;
    const double w44 = w41 * w43;
    const double w45 = 5.0 * w36;
    const double w46 = w45 + c[38][l];
    const double w47 = lane_max(0.0, w46);
    const double w48 = w47 * w47;
    const double w49 = w47 * w48;
    const double w50 = (-0.5) * w47;
    const double w51 = w50 + 1.0;
    const double w52 = w49 * w51;
    const double w53 = 0.2 * w44;
    const double w54 = w36 + w53;
    const double w55 = (-0.2) * w52;
    const double w56 = w54 + w55;
    const double w57 = w56 * w27;
    const double w58 = w7 + 1e-08;
    const double w59 = u1 * w0;
    const double w60 = u0 * w2;
    const double w61 = -w60;
    const double w62 = w59 + w61;
    const double w63 = -w62;
    const double w64 = x1 + w63;
    const double w65 = w64 * w64;
    const double w66 = w58 + w65;
    const double w67 = w66 * w6;
    const double w68 = sqrt(w58);
    const double w69 = 1.0 / w68;
    const double w70 = w67 * w69;
    const double w71 = c[44][l] * w70;
    const double w72 = w71 + c[32][l];
    const double w73 = c[40][l] * w57;
    const double w74 = w72 + w73;
    const double w75 = c[3][l] * u3;
    const double w76 = w75 + c[48][l];
    const double w77 = w66 * w76;
    const double w78 = c[49][l] * u2;
    const double w79 = c[47][l] * w77;
    const double w80 = w78 + w79;
    const double w81 = c[46][l] * w57;
    const double w82 = w80 + w81;
    const double w83 = c[45][l] * w74;
    const double w84 = w83 + w82;
    const double w85 = c[50][l] * x2;
    const double w86 = x1 + w85;
    const double w87 = c[58][l] * x0;
    const double w88 = c[59][l] * x2;
    const double w89 = w87 + w88;
    const double w90 = c[56][l] * w86;
    const double w91 = w89 + w90;
    const double w92 = w91 * w91;
    const double w93 = c[61][l] * x0;
    const double w94 = c[62][l] * x2;
    const double w95 = w93 + w94;
    const double w96 = c[58][l] * w86;
    const double w97 = w95 + w96;
    const double w98 = w97 * w97;
    const double w99 = w92 + w98;
    const double w100 = w99 * w99;
    const double w101 = w100 + c[60][l];
    const double w102 = sqrt(w101);
    const double w103 = sqrt(w102);
    const double w104 = 1.0 / w103;
    const double w105 = w91 * w104;
    const double w106 = w92 + c[66][l];
    const double w107 = sqrt(w106);
    const double w108 = 1.0 / w107;
    const double w109 = w97 * w108;
    const double w110 = w98 + w106;
    const double w111 = sqrt(w110);
    const double w112 = 1.0 / w102;
    const double w113 = w98 * w112;
    const double w114 = w113 + 5e-13;
    const double w115 = 1.0 / w114;
    const double w116 = 50.0 * u4;
    const double w117 = u4 + (-0.02);
    const double w118 = c[74][l] * x2;
    const double w119 = w87 + w118;
    const double w120 = c[61][l] * w86;
    const double w121 = w119 + w120;
    const double w122 = w121 * w121;
    const double w123 = c[56][l] * x0;
    const double w124 = c[75][l] * x2;
    const double w125 = w123 + w124;
    const double w126 = w125 + w96;
    const double w127 = w126 * w126;
    const double w128 = w122 + w127;
    const double w129 = w128 * w128;
    const double w130 = w129 + c[60][l];
    const double w131 = sqrt(w130);
    const double w132 = sqrt(w131);
    const double w133 = 1.0 / w132;
    const double w134 = w121 * w133;
    const double w135 = w122 + c[66][l];
    const double w136 = sqrt(w135);
    const double w137 = 1.0 / w136;
    const double w138 = w126 * w137;
    const double w139 = w127 + w135;
    const double w140 = sqrt(w139);
    const double w141 = 1.0 / w131;
    const double w142 = w127 * w141;
    const double w143 = w142 + 5e-13;
    const double w144 = 1.0 / w143;
    const double w145 = 50.0 * u5;
    const double w146 = u5 + (-0.02);
    const double w147 = c[50][l] * w74;
    const double w148 = w147 + w82;
    const double w149 = c[15][l] * u6;
    const double w150 = w149 + u7;
    const double w151 = c[81][l] * w150;
    const double w152 = lane_cos(w151);
    const double w153 = x0 * w152;
    const double w154 = c[45][l] * x2;
    const double w155 = x1 + w154;
    const double w156 = lane_sin(w151);
    const double w157 = w155 * w156;
    const double w158 = w153 + w157;
    const double w159 = w158 * w158;
    const double w160 = w155 * w152;
    const double w161 = x0 * w156;
    const double w162 = -w161;
    const double w163 = w160 + w162;
    const double w164 = w163 * w163;
    const double w165 = w159 + w164;
    const double w166 = w165 * w165;
    const double w167 = w166 + c[60][l];
    const double w168 = sqrt(w167);
    const double w169 = sqrt(w168);
    const double w170 = 1.0 / w169;
    const double w171 = w158 * w170;
    const double w172 = w159 + c[66][l];
    const double w173 = sqrt(w172);
    const double w174 = 1.0 / w173;
    const double w175 = w163 * w174;
    const double w176 = w164 + w172;
    const double w177 = sqrt(w176);
    const double w178 = c[99][l] * x2;
    const double w179 = x1 + w178;
    const double w180 = w179 + w63;
    const double w181 = lane_atan2(w180, w28);
    const double w182 = c[100][l] * u6;
    const double w183 = w182 + u8;
    const double w184 = c[101][l] * w183;
    const double w185 = w184 + w181;
    const double w186 = c[31][l] * w185;
    const double w187 = lane_min(c[96][l], w186);
    const double w188 = lane_max(c[97][l], w187);
    const double w189 = (-5.0) * w188;
    const double w190 = w189 + c[102][l];
    const double w191 = lane_max(0.0, w190);
    const double w192 = w191 * w191;
    const double w193 = w191 * w192;
    const double w194 = (-0.5) * w191;
    const double w195 = w194 + 1.0;
    const double w196 = w193 * w195;
    const double w197 = 5.0 * w188;
    const double w198 = w197 + c[102][l];
    const double w199 = lane_max(0.0, w198);
    const double w200 = w199 * w199;
    const double w201 = w199 * w200;
    const double w202 = (-0.5) * w199;
    const double w203 = w202 + 1.0;
    const double w204 = w201 * w203;
    const double w205 = w180 * w180;
    const double w206 = 0.2 * w196;
    const double w207 = w188 + w206;
    const double w208 = (-0.2) * w204;
    const double w209 = w207 + w208;
    const double w210 = w27 + w205;
    const double w211 = w209 * w210;
    const double w212 = sqrt(w66);
    const double w213 = w212 * x2;
    const double w214 = lane_atan2(w64, w68);
    const double w215 = c[25][l] * w183;
    const double w216 = c[24][l] * w214;
    const double w217 = w215 + w216;
    const double w218 = w66 * w217;
    const double w219 = c[28][l] * u9;
    const double w220 = c[30][l] * w183;
    const double w221 = w219 + w220;
    const double w222 = c[29][l] * w214;
    const double w223 = w221 + w222;
    const double w224 = w66 * w223;
    const double w225 = x0 * w0;
    const double w226 = x1 * w2;
    const double w227 = -w226;
    const double w228 = w225 + w227;
    const double w229 = x0 * w2;
    const double w230 = x1 * w0;
    const double w231 = w229 + w230;
    const double w232 = c[123][l] * w84;
    const double w233 = lane_max(0.0, w232);
    const double w234 = lane_atan(w109);
    const double w235 = c[7][l] * w233;
    const double w236 = w235 + c[6][l];
    const double w237 = lane_max(0.001, w236);
    const double w238 = c[8][l] * w237;
    const double w239 = w238 + c[54][l];
    const double w240 = u4 * w239;
    const double w241 = 1.0 / w237;
    const double w242 = w240 + c[12][l];
    const double w243 = w242 * w241;
    const double w244 = c[55][l] * w243;
    const double w245 = w244 + 5e-06;
    const double w246 = lane_min(w245, w105);
    const double w247 = -w245;
    const double w248 = lane_max(w247, w246);
    const double w249 = c[63][l] * w243;
    const double w250 = w249 + 0.5;
    const double w251 = (-100000.0) * w248;
    const double w252 = w250 + w251;
    const double w253 = lane_max(0.0, w252);
    const double w254 = w253 * w253;
    const double w255 = w253 * w254;
    const double w256 = (-0.5) * w253;
    const double w257 = w256 + 1.0;
    const double w258 = w255 * w257;
    const double w259 = 100000.0 * w248;
    const double w260 = w250 + w259;
    const double w261 = lane_max(0.0, w260);
    const double w262 = w261 * w261;
    const double w263 = w261 * w262;
    const double w264 = (-0.5) * w261;
    const double w265 = w264 + 1.0;
    const double w266 = w263 * w265;
    const double w267 = 1e-05 * w258;
    const double w268 = w248 + w267;
    const double w269 = (-1e-05) * w266;
    const double w270 = w268 + w269;
    const double w271 = w233 * w270;
    const double w272 = w271 * w237;
    const double w273 = c[8][l] * w272;
    const double w274 = w270 * w270;
    const double w275 = -w274;
    const double w276 = w275 + 1.0;
    const double w277 = sqrt(w276);
    const double w278 = w277 + 5e-06;
    const double w279 = c[5][l] * w233;
    const double w280 = w279 + c[4][l];
    const double w281 = lane_max(0.0, w280);
    const double w282 = w281 * w109;
    const double w283 = w282 * w241;
    const double w284 = c[55][l] * w283;
    const double w285 = lane_min(w284, c[64][l]);
    const double w286 = lane_max(c[65][l], w285);
    const double w287 = c[9][l] * w286;
    const double w288 = lane_atan(w287);
    const double w289 = c[67][l] * w286;
    const double w290 = c[68][l] * w288;
    const double w291 = w289 + w290;
    const double w292 = c[9][l] * w291;
    const double w293 = lane_atan(w292);
    const double w294 = c[10][l] * w293;
    const double w295 = lane_sin(w294);
    const double w296 = w295 * w111;
    const double w297 = w97 * w296;
    const double w298 = w297 * w112;
    const double w299 = c[11][l] * w298;
    const double w300 = w299 + 1e-12;
    const double w301 = w300 * w115;
    const double w302 = (-50.0) * w301;
    const double w303 = w116 + w302;
    const double w304 = lane_min(1.0, w303);
    const double w305 = lane_max(0.0, w304);
    const double w306 = w305 * w305;
    const double w307 = w305 * w306;
    const double w308 = (-8.0) * w305;
    const double w309 = w308 + 6.0;
    const double w310 = 3.0 * w306;
    const double w311 = w309 + w310;
    const double w312 = w307 * w311;
    const double w313 = -w301;
    const double w314 = w117 + w313;
    const double w315 = lane_max(0.0, w314);
    const double w316 = 0.02 * w312;
    const double w317 = w316 + w315;
    const double w318 = w97 * w317;
    const double w319 = w318 * w104;
    const double w320 = w296 * w104;
    const double w321 = c[11][l] * w320;
    const double w322 = w319 + w321;
    const double w323 = lane_min(w322, w278);
    const double w324 = -w278;
    const double w325 = lane_max(w324, w323);
    const double w326 = (-100000.0) * w277;
    const double w327 = w326 + 0.5;
    const double w328 = (-100000.0) * w325;
    const double w329 = w327 + w328;
    const double w330 = lane_max(0.0, w329);
    const double w331 = w330 * w330;
    const double w332 = w330 * w331;
    const double w333 = (-0.5) * w330;
    const double w334 = w333 + 1.0;
    const double w335 = w332 * w334;
    const double w336 = 100000.0 * w325;
    const double w337 = w327 + w336;
    const double w338 = lane_max(0.0, w337);
    const double w339 = w338 * w338;
    const double w340 = w338 * w339;
    const double w341 = (-0.5) * w338;
    const double w342 = w341 + 1.0;
    const double w343 = w340 * w342;
    const double w344 = 1e-05 * w335;
    const double w345 = w325 + w344;
    const double w346 = (-1e-05) * w343;
    const double w347 = w345 + w346;
    const double w348 = w233 * w347;
    const double w349 = w348 * w237;
    const double w350 = c[8][l] * w349;
    const double w351 = lane_atan(w138);
    const double w352 = c[13][l] * w237;
    const double w353 = w352 + c[72][l];
    const double w354 = u5 * w353;
    const double w355 = w354 + c[14][l];
    const double w356 = w355 * w241;
    const double w357 = c[73][l] * w356;
    const double w358 = w357 + 5e-06;
    const double w359 = lane_min(w358, w134);
    const double w360 = -w358;
    const double w361 = lane_max(w360, w359);
    const double w362 = c[76][l] * w356;
    const double w363 = w362 + 0.5;
    const double w364 = (-100000.0) * w361;
    const double w365 = w363 + w364;
    const double w366 = lane_max(0.0, w365);
    const double w367 = w366 * w366;
    const double w368 = w366 * w367;
    const double w369 = (-0.5) * w366;
    const double w370 = w369 + 1.0;
    const double w371 = w368 * w370;
    const double w372 = 100000.0 * w361;
    const double w373 = w363 + w372;
    const double w374 = lane_max(0.0, w373);
    const double w375 = w374 * w374;
    const double w376 = w374 * w375;
    const double w377 = (-0.5) * w374;
    const double w378 = w377 + 1.0;
    const double w379 = w376 * w378;
    const double w380 = 1e-05 * w371;
    const double w381 = w361 + w380;
    const double w382 = (-1e-05) * w379;
    const double w383 = w381 + w382;
    const double w384 = w233 * w383;
    const double w385 = w384 * w237;
    const double w386 = c[13][l] * w385;
    const double w387 = w383 * w383;
    const double w388 = -w387;
    const double w389 = w388 + 1.0;
    const double w390 = sqrt(w389);
    const double w391 = w390 + 5e-06;
    const double w392 = w281 * w138;
    const double w393 = w392 * w241;
    const double w394 = c[73][l] * w393;
    const double w395 = lane_min(w394, c[64][l]);
    const double w396 = lane_max(c[65][l], w395);
    const double w397 = c[9][l] * w396;
    const double w398 = lane_atan(w397);
    const double w399 = c[67][l] * w396;
    const double w400 = c[68][l] * w398;
    const double w401 = w399 + w400;
    const double w402 = c[9][l] * w401;
    const double w403 = lane_atan(w402);
    const double w404 = c[10][l] * w403;
    const double w405 = lane_sin(w404);
    const double w406 = w405 * w140;
    const double w407 = w126 * w406;
    const double w408 = w407 * w141;
    const double w409 = c[11][l] * w408;
    const double w410 = w409 + 1e-12;
    const double w411 = w410 * w144;
    const double w412 = (-50.0) * w411;
    const double w413 = w145 + w412;
    const double w414 = lane_min(1.0, w413);
    const double w415 = lane_max(0.0, w414);
    const double w416 = w415 * w415;
    const double w417 = w415 * w416;
    const double w418 = (-8.0) * w415;
    const double w419 = w418 + 6.0;
    const double w420 = 3.0 * w416;
    const double w421 = w419 + w420;
    const double w422 = w417 * w421;
    const double w423 = -w411;
    const double w424 = w146 + w423;
    const double w425 = lane_max(0.0, w424);
    const double w426 = 0.02 * w422;
    const double w427 = w426 + w425;
    const double w428 = w126 * w427;
    const double w429 = w428 * w133;
    const double w430 = w406 * w133;
    const double w431 = c[11][l] * w430;
    const double w432 = w429 + w431;
    const double w433 = lane_min(w432, w391);
    const double w434 = -w391;
    const double w435 = lane_max(w434, w433);
    const double w436 = (-100000.0) * w390;
    const double w437 = w436 + 0.5;
    const double w438 = (-100000.0) * w435;
    const double w439 = w437 + w438;
    const double w440 = lane_max(0.0, w439);
    const double w441 = w440 * w440;
    const double w442 = w440 * w441;
    const double w443 = (-0.5) * w440;
    const double w444 = w443 + 1.0;
    const double w445 = w442 * w444;
    const double w446 = 100000.0 * w435;
    const double w447 = w437 + w446;
    const double w448 = lane_max(0.0, w447);
    const double w449 = w448 * w448;
    const double w450 = w448 * w449;
    const double w451 = (-0.5) * w448;
    const double w452 = w451 + 1.0;
    const double w453 = w450 * w452;
    const double w454 = 1e-05 * w445;
    const double w455 = w435 + w454;
    const double w456 = (-1e-05) * w453;
    const double w457 = w455 + w456;
    const double w458 = w233 * w457;
    const double w459 = w458 * w237;
    const double w460 = c[13][l] * w459;
    const double w461 = c[122][l] * w148;
    const double w462 = lane_max(0.0, w461);
    const double w463 = lane_atan(w175);
    const double w464 = c[19][l] * w462;
    const double w465 = w464 + c[18][l];
    const double w466 = lane_max(0.001, w465);
    const double w467 = 1.0 / w466;
    const double w468 = c[80][l] * w467;
    const double w469 = w468 + 5e-06;
    const double w470 = lane_min(w469, w171);
    const double w471 = -w469;
    const double w472 = lane_max(w471, w470);
    const double w473 = c[82][l] * w467;
    const double w474 = w473 + 0.5;
    const double w475 = (-100000.0) * w472;
    const double w476 = w474 + w475;
    const double w477 = lane_max(0.0, w476);
    const double w478 = w477 * w477;
    const double w479 = w477 * w478;
    const double w480 = (-0.5) * w477;
    const double w481 = w480 + 1.0;
    const double w482 = w479 * w481;
    const double w483 = 100000.0 * w472;
    const double w484 = w474 + w483;
    const double w485 = lane_max(0.0, w484);
    const double w486 = w485 * w485;
    const double w487 = w485 * w486;
    const double w488 = (-0.5) * w485;
    const double w489 = w488 + 1.0;
    const double w490 = w487 * w489;
    const double w491 = 1e-05 * w482;
    const double w492 = w472 + w491;
    const double w493 = (-1e-05) * w490;
    const double w494 = w492 + w493;
    const double w495 = w462 * w494;
    const double w496 = w495 * w466;
    const double w497 = c[20][l] * w496;
    const double w498 = w494 * w494;
    const double w499 = -w498;
    const double w500 = w499 + 1.0;
    const double w501 = sqrt(w500);
    const double w502 = w501 + 5e-06;
    const double w503 = c[17][l] * w462;
    const double w504 = w503 + c[16][l];
    const double w505 = lane_max(0.0, w504);
    const double w506 = w505 * w175;
    const double w507 = w506 * w467;
    const double w508 = c[79][l] * w507;
    const double w509 = lane_min(w508, c[83][l]);
    const double w510 = lane_max(c[84][l], w509);
    const double w511 = c[21][l] * w510;
    const double w512 = lane_atan(w511);
    const double w513 = c[86][l] * w510;
    const double w514 = c[85][l] * w512;
    const double w515 = w513 + w514;
    const double w516 = c[21][l] * w515;
    const double w517 = lane_atan(w516);
    const double w518 = c[22][l] * w517;
    const double w519 = lane_sin(w518);
    const double w520 = w519 * w177;
    const double w521 = w520 * w170;
    const double w522 = c[23][l] * w521;
    const double w523 = lane_min(w522, w502);
    const double w524 = -w502;
    const double w525 = lane_max(w524, w523);
    const double w526 = (-100000.0) * w501;
    const double w527 = w526 + 0.5;
    const double w528 = (-100000.0) * w525;
    const double w529 = w527 + w528;
    const double w530 = lane_max(0.0, w529);
    const double w531 = w530 * w530;
    const double w532 = w530 * w531;
    const double w533 = (-0.5) * w530;
    const double w534 = w533 + 1.0;
    const double w535 = w532 * w534;
    const double w536 = 100000.0 * w525;
    const double w537 = w527 + w536;
    const double w538 = lane_max(0.0, w537);
    const double w539 = w538 * w538;
    const double w540 = w538 * w539;
    const double w541 = (-0.5) * w538;
    const double w542 = w541 + 1.0;
    const double w543 = w540 * w542;
    const double w544 = 1e-05 * w535;
    const double w545 = w525 + w544;
    const double w546 = (-1e-05) * w543;
    const double w547 = w545 + w546;
    const double w548 = w462 * w547;
    const double w549 = w548 * w466;
    const double w550 = c[87][l] * w549;
    const double w551 = c[43][l] * w66;
    const double w552 = c[89][l] * w66;
    const double w553 = c[106][l] * w213;
    const double w554 = c[42][l] * w218;
    const double w555 = w553 + w554;
    const double w556 = c[26][l] * u9;
    const double w557 = c[27][l] * w214;
    const double w558 = w556 + w557;
    const double w559 = w66 * w558;
    const double w560 = c[124][l] * w213;
    const double w561 = c[111][l] * w559;
    const double w562 = w560 + w561;
    const double w563 = c[125][l] * w213;
    const double w564 = c[111][l] * w224;
    const double w565 = w563 + w564;
    const double w566 = c[103][l] * w211;
    const double w567 = c[39][l] * w57;
    const double w568 = w231 * w231;
    const double w569 = w228 * w228;
    const double w570 = w568 + 1e-12;
    const double w571 = w570 + w569;
    const double w572 = sqrt(w571);
    const double w573 = c[71][l] * w272;
    const double w574 = c[69][l] * w349;
    const double w575 = w573 + w574;
    const double w576 = c[77][l] * w385;
    const double w577 = c[78][l] * w459;
    const double w578 = w576 + w577;
    const double w579 = w549 * w156;
    const double w580 = w496 * w152;
    const double w581 = c[88][l] * w580;
    const double w582 = c[87][l] * w579;
    const double w583 = w581 + w582;
    const double w584 = c[90][l] * w70;
    const double w585 = u2 + w584;
    const double w586 = w585 + w575;
    const double w587 = -w578;
    const double w588 = w586 + w587;
    const double w589 = w588 + w583;
    const double w590 = c[69][l] * w272;
    const double w591 = c[70][l] * w349;
    const double w592 = w590 + w591;
    const double w593 = c[78][l] * w385;
    const double w594 = c[107][l] * w459;
    const double w595 = w593 + w594;
    const double w596 = w496 * w156;
    const double w597 = w549 * w152;
    const double w598 = c[20][l] * w596;
    const double w599 = c[87][l] * w597;
    const double w600 = w598 + w599;
    const double w601 = c[104][l] * w211;
    const double w602 = u10 + w601;
    const double w603 = w602 + w555;
    const double w604 = -w592;
    const double w605 = w603 + w604;
    const double w606 = w605 + w595;
    const double w607 = -w600;
    const double w608 = w606 + w607;
    const double w609 = c[98][l] * u10;
    const double w610 = c[112][l] * w211;
    const double w611 = w609 + w610;
    const double w612 = w611 + w565;
    const double w613 = c[57][l] * w575;
    const double w614 = w612 + w613;
    const double w615 = c[57][l] * w578;
    const double w616 = w614 + w615;
    const double w617 = c[113][l] * w592;
    const double w618 = w616 + w617;
    const double w619 = c[50][l] * w595;
    const double w620 = w618 + w619;
    const double w621 = c[51][l] * w600;
    const double w622 = w620 + w621;
    const double w623 = c[91][l] * w589;
    const double w624 = c[91][l] * w608;
    const double w625 = c[126][l] * u10;
    const double w626 = c[127][l] * w211;
    const double w627 = w625 + w626;
    const double w628 = -w562;
    const double w629 = w627 + w628;
    const double w630 = c[128][l] * w592;
    const double w631 = w629 + w630;
    const double w632 = c[129][l] * w595;
    const double w633 = w631 + w632;
    const double w634 = c[130][l] * w600;
    const double w635 = w633 + w634;
    const double w636 = c[135][l] * u2;
    const double w637 = c[132][l] * w77;
    const double w638 = w636 + w637;
    const double w639 = c[131][l] * w57;
    const double w640 = w638 + w639;
    const double w641 = c[133][l] * w575;
    const double w642 = w640 + w641;
    const double w643 = c[134][l] * w578;
    const double w644 = w642 + w643;
    const double w645 = c[130][l] * w583;
    const double w646 = w644 + w645;
    const double w647 = w572 + c[136][l];
    const double w648 = fabs(x4);
    const double w649 = w648 + c[137][l];
    const double w650 = fabs(x5);
    const double w651 = w650 + c[138][l];
    *y0 = w233;
    *y1 = w234;
    *y2 = w273;
    *y3 = w350;
    *y4 = w233;
    *y5 = w351;
    *y6 = w386;
    *y7 = w460;
    *y8 = w462;
    *y9 = w463;
    *y10 = w497;
    *y11 = w550;
    *y12 = c[0][l];
    *y13 = w214;
    *y14 = c[41][l];
    *y15 = w551;
    *y16 = w552;
    *y17 = w555;
    *y18 = w562;
    *y19 = w79;
    *y20 = w565;
    *y21 = w181;
    *y22 = w209;
    *y23 = w566;
    *y24 = w33;
    *y25 = w56;
    *y26 = w567;
    *y27 = w572;
    *y28 = w589;
    *y29 = w608;
    *y30 = w622;
    *y31 = w623;
    *y32 = w624;
    *y33 = w74;
    *y34 = w635;
    *y35 = w646;
    *y36 = w647;
    *y37 = w649;
    *y38 = w651;
}

APART void observe_lanes(const lanes *c, const lanes *u, const lanes *x, lanes *y)
{
    LANE_LOOP {
        output(c, l, PICK(x, S0, l), PICK(x, S1, l), PICK(x, S2, l), PICK(x, S4, l), PICK(x, S5, l), u[0][l], u[1][l], u[2][l], u[3][l], u[4][l], u[5][l], u[6][l], u[7][l], u[8][l], u[9][l], u[10][l], &y[0][l], &y[1][l], &y[2][l], &y[3][l], &y[4][l], &y[5][l], &y[6][l], &y[7][l], &y[8][l], &y[9][l], &y[10][l], &y[11][l], &y[12][l], &y[13][l], &y[14][l], &y[15][l], &y[16][l], &y[17][l], &y[18][l], &y[19][l], &y[20][l], &y[21][l], &y[22][l], &y[23][l], &y[24][l], &y[25][l], &y[26][l], &y[27][l], &y[28][l], &y[29][l], &y[30][l], &y[31][l], &y[32][l], &y[33][l], &y[34][l], &y[35][l], &y[36][l], &y[37][l], &y[38][l]);
    }
}

APART void observe_row(const lanes *c, int l, double (*u)[TILE], double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, PICK(x, S0, s), PICK(x, S1, s), PICK(x, S2, s), PICK(x, S4, s), PICK(x, S5, s), u[0][s], u[1][s], u[2][s], u[3][s], u[4][s], u[5][s], u[6][s], u[7][s], u[8][s], u[9][s], u[10][s], &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s], &y[11][s], &y[12][s], &y[13][s], &y[14][s], &y[15][s], &y[16][s], &y[17][s], &y[18][s], &y[19][s], &y[20][s], &y[21][s], &y[22][s], &y[23][s], &y[24][s], &y[25][s], &y[26][s], &y[27][s], &y[28][s], &y[29][s], &y[30][s], &y[31][s], &y[32][s], &y[33][s], &y[34][s], &y[35][s], &y[36][s], &y[37][s], &y[38][s]);
}


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

/* Rodas5P: a Rosenbrock method of eight stages and fifth order, L-stable and stiffly accurate
 * (Steinebach, BIT Numer. Math. 63, 2023, 27).  Each step solves linear systems with the Jacobian,
 * so that what is fast and dies out does not limit it. */
enum { STAGES = 8, KEPT_STAGES = 8, DENSE_TERMS = 3, ORDER = 5 };

static const double SHARE = 0.2;       /* local tolerance tau / tol */
static const double TRUST = 0.5;           /* estimated global error / tol that is accepted */
static const double GAMMA = 0.21193756319429014;
static const double DELTA = 1e-4;          /* part of a step over which inputs are differenced */

typedef struct {
    lanes jacobian[NS][ND1], lu[ND1][ND1], right[NS], slope[NS], local;
    lanes h_before, e_before;              /* of the last step that was accepted; 0 after a failure */
} method_t;

typedef struct { lanes e[NS], doubt; } errors_t;


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

/* ---- a step of Rodas5P -------------------------------------------------------------------- */

/* Rates and Jacobian at the beginning of the step; derivative of the rates by time, which is that
 * of the inputs, by differences. */
static void begin_step(block_t *b, const job_t *job)
{
    method_t *m = &b->method;
    set_inputs_at(b, 0.0);
    jacobian(b->c, INPUTS(b), b->x, b->k[0], m->jacobian);
    /* a derivative that does not exist, as of a length at 0, is none */
    for (int i = 0; i < NS; ++i)
        for (int j = 0; j < ND; ++j)
            LANE_LOOP {
                const double entry = m->jacobian[i][j][l];
                m->jacobian[i][j][l] = entry - entry == 0.0 ? entry : 0.0;
            }
#if VARYING
    if (!job->signals)
        return;
    lanes ahead[NS];
    set_inputs_at(b, DELTA);
    rates(b->c, INPUTS(b), b->x, ahead);
    set_inputs_at(b, -DELTA);
    rates(b->c, INPUTS(b), b->x, m->slope);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP m->slope[j][l] = (ahead[j][l] - m->slope[j][l]) / (2.0 * DELTA);
#endif
}

/* Factors of 1 - h gamma J of the dynamic states, without exchange of rows; reciprocals on the
 * diagonal. */
APART void factorise(block_t *b)
{
    method_t *m = &b->method;
    for (int i = 0; i < ND; ++i)
        for (int j = 0; j < ND; ++j)
            LANE_LOOP m->lu[i][j][l] = (i == j ? 1.0 : 0.0) - GAMMA * b->h[l] * m->jacobian[i][j][l];
    for (int k = 0; k < ND; ++k) {
        LANE_LOOP m->lu[k][k][l] = 1.0 / m->lu[k][k][l];
        for (int i = k + 1; i < ND; ++i) {
            LANE_LOOP m->lu[i][k][l] *= m->lu[k][k][l];
            for (int j = k + 1; j < ND; ++j)
                LANE_LOOP m->lu[i][j][l] -= m->lu[i][k][l] * m->lu[k][j][l];
        }
    }
}

/* Solve (1 - h gamma J) y = r in place; the integrals follow from the dynamic states. */
APART void solve(const block_t *b, lanes *r)
{
    const method_t *m = &b->method;
    for (int i = 1; i < ND; ++i)
        for (int j = 0; j < i; ++j)
            LANE_LOOP r[i][l] -= m->lu[i][j][l] * r[j][l];
    for (int i = ND - 1; i >= 0; --i) {
        for (int j = i + 1; j < ND; ++j)
            LANE_LOOP r[i][l] -= m->lu[i][j][l] * r[j][l];
        LANE_LOOP r[i][l] *= m->lu[i][i][l];
    }
    for (int i = ND; i < NS; ++i) {
        lanes sum;
        LANE_LOOP sum[l] = 0.0;
        for (int j = 0; j < ND; ++j)
            LANE_LOOP sum[l] += m->jacobian[i][j][l] * r[j][l];
        LANE_LOOP r[i][l] += GAMMA * b->h[l] * sum[l];
    }
}

/* Rates at a stage's states in b->at, at c of the step, go to m->right. */
static void stage_rates(block_t *b, double c)
{
    set_inputs_at(b, c);
    rates(b->c, INPUTS(b), b->at, b->method.right);
}

static void stage0(block_t *b)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[0][j][l] = GAMMA * (h * b->k[0][j][l] + h * 0.21193756319429014 * b->method.slope[j][l]);
        }
    solve(b, b->k[0]);
}

static void stage1(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + 3.0 * b->k[0][j][l];
    stage_rates(b, 0.6358126895828704);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[1][j][l] = GAMMA * (h * b->method.right[j][l] + -14.155112264123755 * b->k[0][j][l] + h * -0.42387512638858027 * b->method.slope[j][l]);
        }
    solve(b, b->k[1]);
}

static void stage2(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + 2.849394379747939 * b->k[0][j][l] + 0.45842242204463923 * b->k[1][j][l];
    stage_rates(b, 0.4095798393397535);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[2][j][l] = GAMMA * (h * b->method.right[j][l] + -17.97296035885952 * b->k[0][j][l] + -2.859693295451294 * b->k[1][j][l] + h * -0.3384627126235924 * b->method.slope[j][l]);
        }
    solve(b, b->k[2]);
}

static void stage3(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + -6.954028509809101 * b->k[0][j][l] + 2.489845061869568 * b->k[1][j][l] + -10.358996098473584 * b->k[2][j][l];
    stage_rates(b, 0.9769306725060716);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[3][j][l] = GAMMA * (h * b->method.right[j][l] + 147.12150275711716 * b->k[0][j][l] + -1.41221402718213 * b->k[1][j][l] + 71.68940251302358 * b->k[2][j][l] + h * 1.8046452872882734 * b->method.slope[j][l]);
        }
    solve(b, b->k[3]);
}

static void stage4(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + 2.8029986275628964 * b->k[0][j][l] + 0.5072464736228206 * b->k[1][j][l] + -0.3988312541770524 * b->k[2][j][l] + -0.04721187230404641 * b->k[3][j][l];
    stage_rates(b, 0.4288403609558664);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[4][j][l] = GAMMA * (h * b->method.right[j][l] + 165.43517024871676 * b->k[0][j][l] + -0.4592823456491126 * b->k[1][j][l] + 42.90938336958603 * b->k[2][j][l] + -5.961986721573306 * b->k[3][j][l] + h * 2.325825639765069 * b->method.slope[j][l]);
        }
    solve(b, b->k[4]);
}

static void stage5(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + -7.502846399306121 * b->k[0][j][l] + 2.561846144803919 * b->k[1][j][l] + -11.627539656261098 * b->k[2][j][l] + -0.18268767659942256 * b->k[3][j][l] + 0.030198172008377946 * b->k[4][j][l];
    stage_rates(b, 1.0);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[5][j][l] = GAMMA * (h * b->method.right[j][l] + 24.854864614690072 * b->k[0][j][l] + -3.0009227002832186 * b->k[1][j][l] + 47.4931110020768 * b->k[2][j][l] + 5.5814197821558125 * b->k[3][j][l] + -0.6610691825249471 * b->k[4][j][l]);
        }
    solve(b, b->k[5]);
}

static void stage6(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + -7.502846399306121 * b->k[0][j][l] + 2.561846144803919 * b->k[1][j][l] + -11.627539656261098 * b->k[2][j][l] + -0.18268767659942256 * b->k[3][j][l] + 0.030198172008377946 * b->k[4][j][l] + 1.0 * b->k[5][j][l];
    stage_rates(b, 1.0);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[6][j][l] = GAMMA * (h * b->method.right[j][l] + 30.91273214028599 * b->k[0][j][l] + -3.1208243349937974 * b->k[1][j][l] + 77.79954646070892 * b->k[2][j][l] + 34.28646028294783 * b->k[3][j][l] + -19.097331116725623 * b->k[4][j][l] + -28.087943162872662 * b->k[5][j][l]);
        }
    solve(b, b->k[6]);
}

static void stage7(block_t *b)
{
    for (int j = 0; j < ND; ++j)
        LANE_LOOP b->at[j][l] = b->x[j][l] + -7.502846399306121 * b->k[0][j][l] + 2.561846144803919 * b->k[1][j][l] + -11.627539656261098 * b->k[2][j][l] + -0.18268767659942256 * b->k[3][j][l] + 0.030198172008377946 * b->k[4][j][l] + 1.0 * b->k[5][j][l] + 1.0 * b->k[6][j][l];
    stage_rates(b, 1.0);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double h = b->h[l];
            b->k[7][j][l] = GAMMA * (h * b->method.right[j][l] + 37.80277123390563 * b->k[0][j][l] + -3.2571969029072276 * b->k[1][j][l] + 112.26918849496327 * b->k[2][j][l] + 66.9347231244047 * b->k[3][j][l] + -40.06618937091002 * b->k[4][j][l] + -54.66780262877968 * b->k[5][j][l] + -9.48861652309627 * b->k[6][j][l]);
        }
    solve(b, b->k[7]);
}

static void attempt(block_t *b, const job_t *job)
{
    begin_step(b, job);
    factorise(b);
    stage0(b);
    stage1(b);
    stage2(b);
    stage3(b);
    stage4(b);
    stage5(b);
    stage6(b);
    stage7(b);
    for (int j = 0; j < NS; ++j)
        LANE_LOOP b->xn[j][l] = b->x[j][l] + -7.502846399306121 * b->k[0][j][l] + 2.561846144803919 * b->k[1][j][l] + -11.627539656261098 * b->k[2][j][l] + -0.18268767659942256 * b->k[3][j][l] + 0.030198172008377946 * b->k[4][j][l] + 1.0 * b->k[5][j][l] + 1.0 * b->k[6][j][l] + 1.0 * b->k[7][j][l];
}

static void prepare_dense(block_t *b)
{
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            b->d[0][j][l] = 25.948786856663858 * b->k[0][j][l] + -2.5579724845846235 * b->k[1][j][l] + 10.433815404888879 * b->k[2][j][l] + -2.3679251022685204 * b->k[3][j][l] + 0.524948541321073 * b->k[4][j][l] + 1.1241088310450404 * b->k[5][j][l] + 0.4272876194431874 * b->k[6][j][l] + -0.17202221070155493 * b->k[7][j][l];
            b->d[1][j][l] = -9.91568850695171 * b->k[0][j][l] + -0.9689944594115154 * b->k[1][j][l] + 3.0438037242978453 * b->k[2][j][l] + -24.495224566215796 * b->k[3][j][l] + 20.176138334709044 * b->k[4][j][l] + 15.98066361424651 * b->k[5][j][l] + -6.789040303419874 * b->k[6][j][l] + -6.710236069923372 * b->k[7][j][l];
            b->d[2][j][l] = 11.419903575922262 * b->k[0][j][l] + 2.8879645146136994 * b->k[1][j][l] + 72.92137995996029 * b->k[2][j][l] + 80.12511834622643 * b->k[3][j][l] + -52.072871366152654 * b->k[4][j][l] + -59.78993625266729 * b->k[5][j][l] + -0.15582684282751913 * b->k[6][j][l] + 4.883087185713722 * b->k[7][j][l];
        }
}


/* The step's error relative to each state's scale so far. */
static void measure(block_t *b, double tol, int between)
{
    lanes sum;
    LANE_LOOP sum[l] = 0.0;
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double w = 1.0 / larger(b->scale[j][l], fabs(b->xn[j][l]));
            const double e = b->k[STAGES - 1][j][l] * w;
            b->weight[j][l] = w;
            sum[l] += e * e;
        }
    LANE_LOOP b->method.local[l] = b->error[l] = sqrt(sum[l]);
}

/* ---- the global error -----------------------------------------------------------------------
 *
 * An error is carried along by the linearised motion, whose exponential over a step is that of a
 * rational function with the factors that are there, and each step adds its own in the direction
 * in which its estimate points.  Squares are summed, as local errors have no common sign. */
static const double BLAME = 1.0;       /* estimated error / length of e */

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    lanes carried[NS], power[NS], length, along, local, turned;
    memcpy(power, e->e, sizeof power);
    for (int k = 0; k < 3; ++k) {
        static const double weight[3] = {-0.023600974682266518, -1.6711688053433855, 2.694769780025652};
        solve(b, power);
        for (int j = 0; j < NS; ++j)
            LANE_LOOP carried[j][l] = (k ? carried[j][l] : 0.0) + weight[k] * power[j][l];
    }
    LANE_LOOP length[l] = along[l] = 0.0;
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double went = b->error[l] <= b->tau[l] ? carried[j][l] : e->e[j][l];
            const double own = b->error[l] <= b->tau[l] ? b->k[STAGES - 1][j][l] : 0.0;
            const double w = b->weight[j][l];
            carried[j][l] = went;
            length[l] += w * went * w * went;
            along[l] += w * went * w * own;
        }
    LANE_LOOP {
        /* the sum points where both do, and is as long as two sides of a right angle */
        const double own = b->error[l] <= b->tau[l] ? b->method.local[l] : 0.0;
        const double sum = length[l] + own * own;
        e->doubt[l] = larger(e->doubt[l], sum);
        turned[l] = sqrt(sum / (sum + 2.0 * fabs(along[l]) + DBL_MIN));
        local[l] = own > 0.0 ? (along[l] < 0.0 ? -1.0 : 1.0) : 0.0;
    }
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double own = local[l] != 0.0 ? local[l] * b->k[STAGES - 1][j][l] : 0.0;
            e->e[j][l] = turned[l] * (carried[j][l] + own);
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

INLINE double inverse_root(double x) { return lane_exp(-0.2 * lane_log(x)); }

/* How much longer the next step may be: as the error says, but not longer than what its change since
 * the last step foretells (Gustafsson), and no longer at all after a failure. */
INLINE double next_factor(block_t *b, int l, double ratio)
{
    method_t *m = &b->method;
    const double e = larger(smaller(ratio, 1e30), 1e-30), h = b->h[l];
    const double wish = SAFETY * inverse_root(e), before = larger(m->e_before[l], 1e-2);
    const double foretold = wish * (h / m->h_before[l]) * inverse_root(larger(e, 1e-2) / before);
    const double most = m->h_before[l] > 0.0 ? smaller(wish, foretold) : smaller(wish, 1.0);
    const int good = ratio <= 1.0;
    m->h_before[l] = good ? h : 0.0;
    m->e_before[l] = e;
    return good ? most : smaller(wish, 0.9);
}

/* State j of lane l at a fraction of the step. */
INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s, bend = b->d[0][j][l] + s * (b->d[1][j][l] + s * b->d[2][j][l]);
    return r * b->x[j][l] + s * (b->xn[j][l] + r * bend);
}

/* Put lane l at the beginning of its trajectory. */
static void begin_method(block_t *b, int l, double tau)
{
    b->method.h_before[l] = DBL_MAX;
    b->method.e_before[l] = 1.0;
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
