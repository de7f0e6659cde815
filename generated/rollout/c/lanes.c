/* Generated from derive/ (digest 64e19826779c900d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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
enum { NS = 6, ND = 4, S0 = 0, S1 = 1, S2 = 2, S3 = 4, S4 = 5, S5 = 3 };
#endif
enum { NU = 11, NP = 90, NY = 39, NU1 = 11, NY1 = 39, ND1 = ND ? ND : 1 };
enum { NC = VARYING ? 251 : 276 };
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
#define WRITE_MOVING(f, s, v) do { if ((s) < ND) WRITE(f, s, v); } while (0)

#if VARYING
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
        const double w10 = 2.0 * w9;
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
        const double w56 = p[11][l] * w55;
        const double w57 = lane_sin(p[12][l]);
        const double w58 = p[15][l] * w57;
        const double w59 = w56 + w58;
        const double w60 = p[39][l] * w55;
        const double w61 = p[40][l] * w57;
        const double w62 = w60 + w61;
        const double w63 = w62 * w17;
        const double w64 = p[30][l] * w52;
        const double w65 = p[28][l] * p[12][l];
        const double w66 = p[27][l] + w65;
        const double w67 = w55 * p[42][l];
        const double w68 = p[36][l] * w55;
        const double w69 = p[41][l] * w57;
        const double w70 = w68 + w69;
        const double w71 = -w70;
        const double w72 = w59 + w71;
        const double w73 = 1.0 / w72;
        const double w74 = 1.0 / p[61][l];
        const double w75 = p[66][l] * w74;
        const double w76 = -p[56][l];
        const double w77 = 1.0 + w76;
        const double w78 = p[16][l] * p[16][l];
        const double w79 = w78 * w78;
        const double w80 = (-100000.0) * w75;
        const double w81 = p[63][l] + -1.0;
        const double w82 = lane_max(1e-12, w81);
        const double w83 = sqrt(w82);
        const double w84 = p[62][l] * w83;
        const double w85 = 1.0 / w84;
        const double w86 = -w85;
        const double w87 = 1e-06 * w78;
        const double w88 = 1.0 / p[62][l];
        const double w89 = w88 * p[63][l];
        const double w90 = -w81;
        const double w91 = w77 * p[61][l];
        const double w92 = -p[61][l];
        const double w93 = w73 * 0.5;
        const double w94 = -w93;
        const double w95 = -p[52][l];
        const double w96 = 1.0 / p[47][l];
        const double w97 = lane_sin(p[13][l]);
        const double w98 = p[14][l] * 0.5;
        const double w99 = lane_cos(p[13][l]);
        const double w100 = w99 * w98;
        const double w101 = -w97;
        const double w102 = w101 * w98;
        const double w103 = (-100000.0) * w96;
        const double w104 = w99 * p[47][l];
        const double w105 = p[49][l] + -1.0;
        const double w106 = lane_max(1e-12, w105);
        const double w107 = sqrt(w106);
        const double w108 = p[48][l] * w107;
        const double w109 = 1.0 / w108;
        const double w110 = -w109;
        const double w111 = -p[49][l];
        const double w112 = 1.0 + w111;
        const double w113 = 1.0 / p[48][l];
        const double w114 = w113 * p[49][l];
        const double w115 = w97 * p[47][l];
        const double w116 = -w115;
        const double w117 = -p[54][l];
        const double w118 = 1.0 / p[53][l];
        const double w119 = -w98;
        const double w120 = w99 * w119;
        const double w121 = w97 * w119;
        const double w122 = (-100000.0) * w118;
        const double w123 = w99 * p[53][l];
        const double w124 = w97 * p[53][l];
        const double w125 = w50 * w50;
        const double w126 = w125 * p[35][l];
        const double w127 = p[34][l] + w126;
        const double w128 = w127 * w52;
        const double w129 = -w128;
        const double w130 = 1.0 / p[38][l];
        const double w131 = w130 * w91;
        const double w132 = w130 * w92;
        const double w133 = w130 * -1.0;
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
        const double w153 = -w123;
        const double w154 = w130 * w148;
        const double w155 = w130 * w124;
        const double w156 = w130 * w152;
        const double w157 = w130 * w52;
        const double w158 = w130 * w153;
        const double w159 = p[71][l] * p[71][l];
        const double w160 = p[77][l] * w159;
        const double w161 = w160 * w151;
        const double w162 = p[71][l] * w52;
        const double w163 = w141 * w147;
        const double w164 = -w163;
        const double w165 = 0.5 * p[14][l];
        const double w166 = -w165;
        const double w167 = -w59;
        const double w168 = w59 * w124;
        const double w169 = w59 * w153;
        const double w170 = 1.0 / p[89][l];
        const double w171 = w170 * w161;
        const double w172 = w170 * w162;
        const double w173 = w170 * w164;
        const double w174 = w170 * w140;
        const double w175 = w170 * w166;
        const double w176 = w170 * w165;
        const double w177 = w170 * w167;
        const double w178 = w170 * w71;
        const double w179 = w170 * w168;
        const double w180 = w170 * w169;
        const double w181 = w159 * w151;
        const double w182 = p[74][l] * w181;
        const double w183 = p[77][l] * w181;
        const double w184 = -w124;
        const double w185 = -w104;
        const double w186 = -w91;
        const double w187 = w165 * w123;
        const double w188 = w165 * w124;
        const double w189 = w187 + w168;
        const double w190 = w188 + w169;
        const double w191 = w167 * w115;
        const double w192 = w167 * w104;
        const double w193 = w71 * p[61][l];
        const double w194 = w71 * w91;
        const double w195 = w57 * p[79][l];
        const double w196 = p[79][l] * w147;
        const double w197 = w57 * w196;
        const double w198 = p[80][l] * w147;
        const double w199 = w55 * w198;
        const double w200 = w197 + w199;
        const double w201 = -w200;
        const double w202 = p[11][l] * p[47][l];
        const double w203 = w57 * w202;
        const double w204 = w97 * w203;
        const double w205 = p[15][l] * p[53][l];
        const double w206 = w97 * w205;
        const double w207 = w55 * w206;
        const double w208 = p[36][l] * p[61][l];
        const double w209 = w57 * w208;
        const double w210 = w99 * w203;
        const double w211 = p[11][l] * p[53][l];
        const double w212 = w57 * w211;
        const double w213 = w99 * w212;
        const double w214 = p[36][l] * w91;
        const double w215 = w57 * w214;
        const double w216 = p[15][l] * w55;
        const double w217 = w216 * w123;
        const double w218 = -w217;
        const double w219 = w213 + w218;
        const double w220 = w216 * w115;
        const double w221 = -w220;
        const double w222 = w204 + w221;
        const double w223 = w216 * w104;
        const double w224 = -w223;
        const double w225 = w210 + w224;
        const double w226 = p[41][l] * w55;
        const double w227 = w226 * p[61][l];
        const double w228 = -w227;
        const double w229 = w209 + w228;
        const double w230 = w226 * w91;
        const double w231 = -w230;
        const double w232 = w215 + w231;
        const double w233 = p[11][l] * w57;
        const double w234 = w233 * w124;
        const double w235 = -w234;
        const double w236 = w207 + w235;
        const double w237 = p[15][l] * p[47][l];
        const double w238 = w55 * w237;
        const double w239 = w99 * w238;
        const double w240 = w60 * w17;
        const double w241 = w61 * w17;
        const double w242 = w240 + w241;
        const double w243 = -w242;
        const double w244 = w55 * w205;
        const double w245 = w99 * w244;
        const double w246 = p[41][l] * p[61][l];
        const double w247 = w55 * w246;
        const double w248 = w216 * p[47][l];
        const double w249 = w97 * w248;
        const double w250 = -w249;
        const double w251 = w204 + w250;
        const double w252 = -w209;
        const double w253 = w247 + w252;
        const double w254 = w233 * w104;
        const double w255 = -w254;
        const double w256 = w239 + w255;
        const double w257 = w233 * w123;
        const double w258 = -w257;
        const double w259 = w245 + w258;
        const double w260 = -p[86][l];
        const double w261 = (-0.5) * p[87][l];
        const double w262 = -p[88][l];
        const double w263 = w75 * w74;
        const double w264 = p[60][l] * w73;
        const double w265 = p[61][l] * w264;
        const double w266 = w263 * w265;
        const double w267 = -w266;
        const double w268 = (-100000.0) * w266;
        const double w269 = -w268;
        const double w270 = p[58][l] * w73;
        const double w271 = w74 * w74;
        const double w272 = w271 * w265;
        const double w273 = -w272;
        const double w274 = p[62][l] * p[62][l];
        const double w275 = p[63][l] * p[62][l];
        const double w276 = w88 * w275;
        const double w277 = p[64][l] * p[62][l];
        const double w278 = p[65][l] * w277;
        const double w279 = p[65][l] * 0.5;
        const double w280 = -w279;
        const double w281 = w96 * w96;
        const double w282 = p[46][l] * w93;
        const double w283 = p[47][l] * w282;
        const double w284 = w281 * w283;
        const double w285 = w283 * w96;
        const double w286 = -w285;
        const double w287 = -w283;
        const double w288 = p[44][l] * w93;
        const double w289 = -w288;
        const double w290 = p[48][l] * p[48][l];
        const double w291 = p[49][l] * p[48][l];
        const double w292 = w113 * w291;
        const double w293 = p[50][l] * p[48][l];
        const double w294 = p[51][l] * w293;
        const double w295 = p[51][l] * 0.5;
        const double w296 = -w295;
        const double w297 = w118 * w118;
        const double w298 = p[53][l] * w282;
        const double w299 = w297 * w298;
        const double w300 = w298 * w118;
        const double w301 = -w300;
        const double w302 = -w298;
        const double w303 = -w129;
        const double w304 = w130 * w77;
        const double w305 = w130 * w303;
        const double w306 = 5.0 * p[82][l];
        const double w307 = 0.5 * w306;
        const double w308 = 0.2 * w307;
        const double w309 = 2.0 * w306;
        const double w310 = -w308;
        const double w311 = -w310;
        const double w312 = w150 * 0.5;
        const double w313 = w149 * p[18][l];
        const double w314 = w52 * p[68][l];
        const double w315 = -w99;
        const double w316 = w130 * w97;
        const double w317 = w130 * w313;
        const double w318 = w130 * w314;
        const double w319 = w130 * w315;
        const double w320 = w160 * p[18][l];
        const double w321 = w162 * p[76][l];
        const double w322 = -w141;
        const double w323 = w59 * w97;
        const double w324 = w59 * w315;
        const double w325 = w170 * w320;
        const double w326 = w170 * w321;
        const double w327 = w170 * w322;
        const double w328 = w170 * w323;
        const double w329 = w170 * w324;
        const double w330 = w51 * 2.0;
        const double w331 = p[18][l] * w330;
        const double w332 = p[30][l] * w331;
        const double w333 = w50 * w331;
        const double w334 = w99 * 2.0;
        const double w335 = w97 * 2.0;
        const double w336 = -w335;
        const double w337 = w334 * 0.5;
        const double w338 = -w96;
        const double w339 = w99 * w287;
        const double w340 = w101 * p[47][l];
        const double w341 = w101 * w287;
        const double w342 = -w339;
        const double w343 = -w340;
        const double w344 = -w341;
        const double w345 = -w337;
        const double w346 = w99 * w302;
        const double w347 = w97 * w302;
        const double w348 = -w346;
        const double w349 = -w347;
        const double w350 = w127 * w331;
        const double w351 = w70 * w333;
        const double w352 = -w351;
        const double w353 = w147 * 2.0;
        const double w354 = -w353;
        const double w355 = w335 * 0.5;
        const double w356 = w315 * p[53][l];
        const double w357 = w315 * w302;
        const double w358 = -w355;
        const double w359 = w97 * w287;
        const double w360 = -w359;
        const double w361 = w59 * w333;
        const double w362 = -w361;
        const double w363 = -w77;
        const double w364 = w130 * w185;
        const double w365 = w130 * w342;
        const double w366 = w130 * w343;
        const double w367 = w130 * w344;
        const double w368 = w130 * w348;
        const double w369 = w130 * w184;
        const double w370 = w130 * w349;
        const double w371 = w130 * w347;
        const double w372 = w130 * w354;
        const double w373 = w130 * w331;
        const double w374 = w130 * w356;
        const double w375 = w130 * w357;
        const double w376 = w130 * w116;
        const double w377 = w130 * w360;
        const double w378 = w130 * w363;
        const double w379 = p[82][l] * w141;
        const double w380 = 5.0 * w379;
        const double w381 = 0.5 * w380;
        const double w382 = 0.2 * w381;
        const double w383 = 2.0 * w380;
        const double w384 = -w382;
        const double w385 = -w384;
        const double w386 = w141 * 2.0;
        const double w387 = w147 * w386;
        const double w388 = w322 * w147;
        const double w389 = w322 * w387;
        const double w390 = w97 * w59;
        const double w391 = w99 * w165;
        const double w392 = w390 + w391;
        const double w393 = w392 * 2.0;
        const double w394 = w99 * w59;
        const double w395 = w97 * w165;
        const double w396 = -w395;
        const double w397 = w394 + w396;
        const double w398 = w397 * 2.0;
        const double w399 = w393 * 0.5;
        const double w400 = -w399;
        const double w401 = w112 * w96;
        const double w402 = p[48][l] * w96;
        const double w403 = p[49][l] * w402;
        const double w404 = w113 * w403;
        const double w405 = w166 * w104;
        const double w406 = w166 * w116;
        const double w407 = w391 + w390;
        const double w408 = w407 * 2.0;
        const double w409 = -w408;
        const double w410 = w408 * 0.5;
        const double w411 = w112 * w118;
        const double w412 = p[48][l] * w118;
        const double w413 = p[49][l] * w412;
        const double w414 = w113 * w413;
        const double w415 = w405 + w191;
        const double w416 = w406 + w192;
        const double w417 = 2.0 * w70;
        const double w418 = w417 * 0.5;
        const double w419 = -w418;
        const double w420 = p[62][l] * w74;
        const double w421 = p[63][l] * w420;
        const double w422 = w88 * w421;
        const double w423 = w81 * w74;
        const double w424 = -w423;
        const double w425 = w170 * w388;
        const double w426 = w170 * w389;
        const double w427 = w372 + w426;
        const double w428 = w170 * w415;
        const double w429 = w170 * w416;
        const double w430 = w170 * w189;
        const double w431 = w170 * w190;
        const double w432 = w170 * w193;
        const double w433 = w170 * w194;
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
        c[36][l] = w9;
        c[37][l] = w10;
        c[38][l] = w12;
        c[39][l] = w14;
        c[40][l] = w17;
        c[41][l] = w18;
        c[42][l] = w50;
        c[43][l] = w52;
        c[44][l] = w53;
        c[45][l] = w54;
        c[46][l] = w59;
        c[47][l] = w63;
        c[48][l] = w64;
        c[49][l] = w66;
        c[50][l] = w67;
        c[51][l] = w70;
        c[52][l] = w71;
        c[53][l] = w73;
        c[54][l] = w74;
        c[55][l] = w75;
        c[56][l] = w77;
        c[57][l] = w79;
        c[58][l] = w80;
        c[59][l] = w85;
        c[60][l] = w86;
        c[61][l] = w87;
        c[62][l] = w89;
        c[63][l] = w90;
        c[64][l] = w91;
        c[65][l] = w92;
        c[66][l] = w94;
        c[67][l] = w95;
        c[68][l] = w96;
        c[69][l] = w97;
        c[70][l] = w99;
        c[71][l] = w100;
        c[72][l] = w101;
        c[73][l] = w102;
        c[74][l] = w103;
        c[75][l] = w104;
        c[76][l] = w109;
        c[77][l] = w110;
        c[78][l] = w112;
        c[79][l] = w114;
        c[80][l] = w115;
        c[81][l] = w116;
        c[82][l] = w117;
        c[83][l] = w118;
        c[84][l] = w120;
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
        c[111][l] = w157;
        c[112][l] = w158;
        c[113][l] = w162;
        c[114][l] = w164;
        c[115][l] = w166;
        c[116][l] = w167;
        c[117][l] = w171;
        c[118][l] = w172;
        c[119][l] = w173;
        c[120][l] = w174;
        c[121][l] = w175;
        c[122][l] = w176;
        c[123][l] = w177;
        c[124][l] = w178;
        c[125][l] = w179;
        c[126][l] = w180;
        c[127][l] = w182;
        c[128][l] = w183;
        c[129][l] = w184;
        c[130][l] = w185;
        c[131][l] = w186;
        c[132][l] = w189;
        c[133][l] = w190;
        c[134][l] = w191;
        c[135][l] = w192;
        c[136][l] = w193;
        c[137][l] = w194;
        c[138][l] = w195;
        c[139][l] = w201;
        c[140][l] = w219;
        c[141][l] = w222;
        c[142][l] = w225;
        c[143][l] = w229;
        c[144][l] = w232;
        c[145][l] = w236;
        c[146][l] = w243;
        c[147][l] = w251;
        c[148][l] = w253;
        c[149][l] = w256;
        c[150][l] = w259;
        c[151][l] = w260;
        c[152][l] = w261;
        c[153][l] = w262;
        c[154][l] = w265;
        c[155][l] = w266;
        c[156][l] = w267;
        c[157][l] = w268;
        c[158][l] = w269;
        c[159][l] = w270;
        c[160][l] = w273;
        c[161][l] = w274;
        c[162][l] = w276;
        c[163][l] = w278;
        c[164][l] = w279;
        c[165][l] = w280;
        c[166][l] = w284;
        c[167][l] = w286;
        c[168][l] = w287;
        c[169][l] = w288;
        c[170][l] = w289;
        c[171][l] = w290;
        c[172][l] = w292;
        c[173][l] = w294;
        c[174][l] = w295;
        c[175][l] = w296;
        c[176][l] = w299;
        c[177][l] = w301;
        c[178][l] = w302;
        c[179][l] = w304;
        c[180][l] = w305;
        c[181][l] = w306;
        c[182][l] = w308;
        c[183][l] = w309;
        c[184][l] = w311;
        c[185][l] = w312;
        c[186][l] = w316;
        c[187][l] = w317;
        c[188][l] = w318;
        c[189][l] = w319;
        c[190][l] = w325;
        c[191][l] = w326;
        c[192][l] = w327;
        c[193][l] = w328;
        c[194][l] = w329;
        c[195][l] = w332;
        c[196][l] = w333;
        c[197][l] = w334;
        c[198][l] = w335;
        c[199][l] = w336;
        c[200][l] = w337;
        c[201][l] = w338;
        c[202][l] = w345;
        c[203][l] = w350;
        c[204][l] = w352;
        c[205][l] = w355;
        c[206][l] = w358;
        c[207][l] = w362;
        c[208][l] = w364;
        c[209][l] = w365;
        c[210][l] = w366;
        c[211][l] = w367;
        c[212][l] = w368;
        c[213][l] = w369;
        c[214][l] = w370;
        c[215][l] = w371;
        c[216][l] = w373;
        c[217][l] = w374;
        c[218][l] = w375;
        c[219][l] = w376;
        c[220][l] = w377;
        c[221][l] = w378;
        c[222][l] = w379;
        c[223][l] = w380;
        c[224][l] = w382;
        c[225][l] = w383;
        c[226][l] = w385;
        c[227][l] = w392;
        c[228][l] = w393;
        c[229][l] = w397;
        c[230][l] = w398;
        c[231][l] = w400;
        c[232][l] = w401;
        c[233][l] = w404;
        c[234][l] = w407;
        c[235][l] = w409;
        c[236][l] = w410;
        c[237][l] = w411;
        c[238][l] = w414;
        c[239][l] = w417;
        c[240][l] = w419;
        c[241][l] = w422;
        c[242][l] = w424;
        c[243][l] = w425;
        c[244][l] = w427;
        c[245][l] = w428;
        c[246][l] = w429;
        c[247][l] = w430;
        c[248][l] = w431;
        c[249][l] = w432;
        c[250][l] = w433;
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
    const double w9 = w8 + 0.0001;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = c[37][l] * u2;
    const double w13 = w12 + w11;
    const double w14 = w13 * w13;
    const double w15 = w14 + 1e-08;
    const double w16 = sqrt(w15);
    const double w17 = c[36][l] * u2;
    const double w18 = 0.5 * w11;
    const double w19 = w17 + w18;
    const double w20 = 0.5 * w16;
    const double w21 = w19 + w20;
    const double w22 = sqrt(w21);
    const double w23 = c[1][l] * u3;
    const double w24 = w23 + c[38][l];
    const double w25 = w8 + 1e-08;
    const double w26 = u1 * w1;
    const double w27 = u0 * w3;
    const double w28 = -w27;
    const double w29 = w26 + w28;
    const double w30 = -w29;
    const double w31 = x1 + w30;
    const double w32 = w31 * w31;
    const double w33 = w25 + w32;
    const double w34 = w33 * w7;
    const double w35 = sqrt(w25);
    const double w36 = 1.0 / w35;
    const double w37 = w34 * w36;
    const double w38 = c[45][l] * w37;
    const double w39 = w38 + c[32][l];
    const double w40 = c[3][l] * u3;
    const double w41 = w40 + c[49][l];
    const double w42 = w33 * w41;
    const double w43 = c[50][l] * u2;
    const double w44 = c[48][l] * w42;
    const double w45 = w43 + w44;
    const double w46 = c[15][l] * u6;
    const double w47 = w46 + u7;
    const double w48 = c[56][l] * w47;
    const double w49 = lane_cos(w48);
    const double w50 = x0 * w49;
    const double w51 = c[51][l] * x2;
    const double w52 = x1 + w51;
    const double w53 = lane_sin(w48);
    const double w54 = w52 * w53;
    const double w55 = w50 + w54;
    const double w56 = w55 * w55;
    const double w57 = w52 * w49;
    const double w58 = x0 * w53;
    const double w59 = -w58;
    const double w60 = w57 + w59;
    const double w61 = w60 * w60;
    const double w62 = w56 + w61;
    const double w63 = w62 * w62;
    const double w64 = w63 + c[57][l];
    const double w65 = sqrt(w64);
    const double w66 = sqrt(w65);
    const double w67 = 1.0 / w66;
    const double w68 = w55 * w67;
    const double w69 = w56 + c[61][l];
    const double w70 = sqrt(w69);
    const double w71 = 1.0 / w70;
    const double w72 = w60 * w71;
    const double w73 = w61 + w69;
    const double w74 = sqrt(w73);
    const double w75 = c[46][l] * x2;
    const double w76 = x1 + w75;
    const double w77 = c[70][l] * x0;
    const double w78 = c[71][l] * x2;
    const double w79 = w77 + w78;
    const double w80 = c[69][l] * w76;
    const double w81 = w79 + w80;
    const double w82 = w81 * w81;
    const double w83 = c[72][l] * x0;
    const double w84 = c[73][l] * x2;
    const double w85 = w83 + w84;
    const double w86 = c[70][l] * w76;
    const double w87 = w85 + w86;
    const double w88 = w87 * w87;
    const double w89 = w82 + w88;
    const double w90 = w89 * w89;
    const double w91 = w90 + c[57][l];
    const double w92 = sqrt(w91);
    const double w93 = sqrt(w92);
    const double w94 = 1.0 / w93;
    const double w95 = w81 * w94;
    const double w96 = w82 + c[61][l];
    const double w97 = sqrt(w96);
    const double w98 = 1.0 / w97;
    const double w99 = w87 * w98;
    const double w100 = w88 + w96;
    const double w101 = sqrt(w100);
    const double w102 = c[84][l] * x2;
    const double w103 = w77 + w102;
    const double w104 = c[72][l] * w76;
    const double w105 = w103 + w104;
    const double w106 = w105 * w105;
    const double w107 = c[69][l] * x0;
    const double w108 = c[85][l] * x2;
    const double w109 = w107 + w108;
    const double w110 = w109 + w86;
    const double w111 = w110 * w110;
    const double w112 = w106 + w111;
    const double w113 = w112 * w112;
    const double w114 = w113 + c[57][l];
    const double w115 = sqrt(w114);
    const double w116 = sqrt(w115);
    const double w117 = 1.0 / w116;
    const double w118 = w105 * w117;
    const double w119 = w106 + c[61][l];
    const double w120 = sqrt(w119);
    const double w121 = 1.0 / w120;
    const double w122 = w110 * w121;
    const double w123 = w111 + w119;
    const double w124 = sqrt(w123);
    const double w125 = c[91][l] * u2;
    const double w126 = w125 + w0;
    const double w127 = c[95][l] * w37;
    const double w128 = w126 + w127;
    const double w129 = c[99][l] * x2;
    const double w130 = x1 + w129;
    const double w131 = w130 + w30;
    const double w132 = c[100][l] * u6;
    const double w133 = w132 + u8;
    const double w134 = c[101][l] * w133;
    const double w135 = w131 * w131;
    const double w136 = w21 + w135;
    const double w137 = sqrt(w33);
    const double w138 = w137 * x2;
    const double w139 = c[25][l] * w133;
    const double w140 = x2 * x0;
    const double w141 = c[91][l] * u10;
    const double w142 = -w140;
    const double w143 = w141 + w142;
    const double w144 = c[110][l] * w138;
    const double w145 = w143 + w144;
    const double w146 = c[28][l] * u9;
    const double w147 = c[30][l] * w133;
    const double w148 = w146 + w147;
    const double w149 = c[120][l] * u10;
    const double w150 = c[117][l] * w138;
    const double w151 = w149 + w150;
    const double w152 = x0 * w1;
    const double w153 = x1 * w3;
    const double w154 = -w153;
    const double w155 = w152 + w154;
    const double w156 = x0 * w3;
    const double w157 = x1 * w1;
    const double w158 = w156 + w157;
    w[0][l] = w21;
    w[1][l] = w22;
    w[2][l] = w24;
    w[3][l] = w31;
    w[4][l] = w33;
    w[5][l] = w35;
    w[6][l] = w39;
    w[7][l] = w45;
    w[10][l] = w49;
    w[11][l] = w53;
    w[12][l] = w67;
    w[13][l] = w68;
    w[15][l] = w72;
    w[20][l] = w74;
    w[25][l] = w94;
    w[26][l] = w95;
    w[28][l] = w99;
    w[33][l] = w101;
    w[37][l] = w117;
    w[38][l] = w118;
    w[40][l] = w122;
    w[45][l] = w124;
    w[49][l] = w128;
    w[51][l] = w131;
    w[52][l] = w134;
    w[53][l] = w136;
    w[54][l] = w139;
    w[57][l] = w145;
    w[59][l] = w148;
    w[60][l] = w151;
    WRITE(f, S3, w155);
    WRITE(f, S4, w158);
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
    const double w7 = w6 + c[39][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[39][l];
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
    const double w27 = c[41][l] * w26;
    const double w28 = w[6][l] + w27;
    const double w29 = c[47][l] * w26;
    const double w30 = w[7][l] + w29;
    const double w31 = c[46][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[53][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[19][l] * w34;
    const double w36 = w35 + c[18][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[55][l] * w38;
    const double w40 = w39 + 5e-06;
    const double w41 = lane_min(w40, w[13][l]);
    const double w42 = -w40;
    const double w43 = lane_max(w42, w41);
    const double w44 = c[58][l] * w38;
    const double w45 = w44 + 0.5;
    const double w46 = (-100000.0) * w43;
    const double w47 = w45 + w46;
    const double w48 = lane_max(0.0, w47);
    const double w49 = w48 * w48;
    const double w50 = w48 * w49;
    const double w51 = (-0.5) * w48;
    const double w52 = w51 + 1.0;
    const double w53 = w50 * w52;
    const double w54 = 100000.0 * w43;
    const double w55 = w45 + w54;
    const double w56 = lane_max(0.0, w55);
    const double w57 = w56 * w56;
    const double w58 = w56 * w57;
    const double w59 = (-0.5) * w56;
    const double w60 = w59 + 1.0;
    const double w61 = w58 * w60;
    const double w62 = 1e-05 * w53;
    const double w63 = w43 + w62;
    const double w64 = (-1e-05) * w61;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = -w66;
    const double w68 = w67 + 1.0;
    const double w69 = sqrt(w68);
    const double w70 = w69 + 5e-06;
    const double w71 = c[17][l] * w34;
    const double w72 = w71 + c[16][l];
    const double w73 = lane_max(0.0, w72);
    const double w74 = w73 * w[15][l];
    const double w75 = w74 * w38;
    const double w76 = c[54][l] * w75;
    const double w77 = lane_min(w76, c[59][l]);
    const double w78 = lane_max(c[60][l], w77);
    const double w79 = c[21][l] * w78;
    const double w80 = c[63][l] * w78;
    const double w81 = -w70;
    const double w82 = (-100000.0) * w69;
    const double w83 = w82 + 0.5;
    const double w84 = w34 * w65;
    const double w85 = w84 * w37;
    const double w86 = w85 * w[10][l];
    const double w87 = c[51][l] * w28;
    const double w88 = w87 + w30;
    const double w89 = c[66][l] * w88;
    const double w90 = lane_max(0.0, w89);
    const double w91 = c[7][l] * w90;
    const double w92 = w91 + c[6][l];
    const double w93 = lane_max(0.001, w92);
    const double w94 = c[8][l] * w93;
    const double w95 = w94 + c[67][l];
    const double w96 = u4 * w95;
    const double w97 = 1.0 / w93;
    const double w98 = w96 + c[12][l];
    const double w99 = w98 * w97;
    const double w100 = c[68][l] * w99;
    const double w101 = w100 + 5e-06;
    const double w102 = lane_min(w101, w[26][l]);
    const double w103 = -w101;
    const double w104 = lane_max(w103, w102);
    const double w105 = c[74][l] * w99;
    const double w106 = w105 + 0.5;
    const double w107 = (-100000.0) * w104;
    const double w108 = w106 + w107;
    const double w109 = lane_max(0.0, w108);
    const double w110 = w109 * w109;
    const double w111 = w109 * w110;
    const double w112 = (-0.5) * w109;
    const double w113 = w112 + 1.0;
    const double w114 = w111 * w113;
    const double w115 = 100000.0 * w104;
    const double w116 = w106 + w115;
    const double w117 = lane_max(0.0, w116);
    const double w118 = w117 * w117;
    const double w119 = w117 * w118;
    const double w120 = (-0.5) * w117;
    const double w121 = w120 + 1.0;
    const double w122 = w119 * w121;
    const double w123 = 1e-05 * w114;
    const double w124 = w104 + w123;
    const double w125 = (-1e-05) * w122;
    const double w126 = w124 + w125;
    const double w127 = w90 * w126;
    const double w128 = w127 * w93;
    const double w129 = w126 * w126;
    const double w130 = -w129;
    const double w131 = w130 + 1.0;
    const double w132 = sqrt(w131);
    const double w133 = w132 + 5e-06;
    const double w134 = c[5][l] * w90;
    const double w135 = w134 + c[4][l];
    const double w136 = lane_max(0.0, w135);
    const double w137 = w136 * w[28][l];
    const double w138 = w137 * w97;
    const double w139 = c[68][l] * w138;
    const double w140 = lane_min(w139, c[76][l]);
    const double w141 = lane_max(c[77][l], w140);
    const double w142 = c[9][l] * w141;
    const double w143 = c[78][l] * w141;
    const double w144 = -w133;
    const double w145 = (-100000.0) * w132;
    const double w146 = w145 + 0.5;
    const double w147 = c[75][l] * w128;
    const double w148 = c[13][l] * w93;
    const double w149 = w148 + c[82][l];
    const double w150 = u5 * w149;
    const double w151 = w150 + c[14][l];
    const double w152 = w151 * w97;
    const double w153 = c[83][l] * w152;
    const double w154 = w153 + 5e-06;
    const double w155 = lane_min(w154, w[38][l]);
    const double w156 = -w154;
    const double w157 = lane_max(w156, w155);
    const double w158 = c[86][l] * w152;
    const double w159 = w158 + 0.5;
    const double w160 = (-100000.0) * w157;
    const double w161 = w159 + w160;
    const double w162 = lane_max(0.0, w161);
    const double w163 = w162 * w162;
    const double w164 = w162 * w163;
    const double w165 = (-0.5) * w162;
    const double w166 = w165 + 1.0;
    const double w167 = w164 * w166;
    const double w168 = 100000.0 * w157;
    const double w169 = w159 + w168;
    const double w170 = lane_max(0.0, w169);
    const double w171 = w170 * w170;
    const double w172 = w170 * w171;
    const double w173 = (-0.5) * w170;
    const double w174 = w173 + 1.0;
    const double w175 = w172 * w174;
    const double w176 = 1e-05 * w167;
    const double w177 = w157 + w176;
    const double w178 = (-1e-05) * w175;
    const double w179 = w177 + w178;
    const double w180 = w90 * w179;
    const double w181 = w180 * w93;
    const double w182 = w179 * w179;
    const double w183 = -w182;
    const double w184 = w183 + 1.0;
    const double w185 = sqrt(w184);
    const double w186 = w185 + 5e-06;
    const double w187 = w136 * w[40][l];
    const double w188 = w187 * w97;
    const double w189 = c[83][l] * w188;
    const double w190 = lane_min(w189, c[76][l]);
    const double w191 = lane_max(c[77][l], w190);
    const double w192 = c[9][l] * w191;
    const double w193 = c[78][l] * w191;
    const double w194 = -w186;
    const double w195 = (-100000.0) * w185;
    const double w196 = w195 + 0.5;
    const double w197 = c[87][l] * w181;
    const double w198 = c[93][l] * w86;
    const double w199 = w[49][l] + w198;
    const double w200 = lane_atan2(w[51][l], w[1][l]);
    const double w201 = w[52][l] + w200;
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
    const double w225 = w224 * w[53][l];
    const double w226 = lane_atan2(w[3][l], w[5][l]);
    const double w227 = c[24][l] * w226;
    const double w228 = w[54][l] + w227;
    const double w229 = w[4][l] * w228;
    const double w230 = c[80][l] * w128;
    const double w231 = w85 * w[11][l];
    const double w232 = c[20][l] * w231;
    const double w233 = c[109][l] * w181;
    const double w234 = w[57][l] + w233;
    const double w235 = c[108][l] * w225;
    const double w236 = w234 + w235;
    const double w237 = c[111][l] * w229;
    const double w238 = w236 + w237;
    const double w239 = c[29][l] * w226;
    const double w240 = w[59][l] + w239;
    const double w241 = w[4][l] * w240;
    const double w242 = c[125][l] * w181;
    const double w243 = w[60][l] + w242;
    const double w244 = c[119][l] * w225;
    const double w245 = w243 + w244;
    const double w246 = c[118][l] * w241;
    const double w247 = w245 + w246;
    w[8][l] = w34;
    w[9][l] = w37;
    w[14][l] = w70;
    w[16][l] = w79;
    w[17][l] = w80;
    w[21][l] = w81;
    w[22][l] = w83;
    w[23][l] = w90;
    w[24][l] = w93;
    w[27][l] = w133;
    w[29][l] = w142;
    w[30][l] = w143;
    w[34][l] = w144;
    w[35][l] = w146;
    w[36][l] = w147;
    w[39][l] = w186;
    w[41][l] = w192;
    w[42][l] = w193;
    w[46][l] = w194;
    w[47][l] = w196;
    w[48][l] = w197;
    w[50][l] = w199;
    w[55][l] = w230;
    w[56][l] = w232;
    w[58][l] = w238;
    w[61][l] = w247;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[16][l]);
    const double w1 = c[62][l] * w0;
    const double w2 = w[17][l] + w1;
    const double w3 = c[21][l] * w2;
    const double w4 = lane_atan(w[29][l]);
    const double w5 = c[79][l] * w4;
    const double w6 = w[30][l] + w5;
    const double w7 = c[9][l] * w6;
    const double w8 = lane_atan(w[41][l]);
    const double w9 = c[79][l] * w8;
    const double w10 = w[42][l] + w9;
    const double w11 = c[9][l] * w10;
    w[18][l] = w3;
    w[31][l] = w7;
    w[43][l] = w11;
}

INLINE void rate3(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[18][l]);
    const double w1 = c[22][l] * w0;
    const double w2 = lane_atan(w[31][l]);
    const double w3 = c[10][l] * w2;
    const double w4 = lane_atan(w[43][l]);
    const double w5 = c[10][l] * w4;
    w[19][l] = w1;
    w[32][l] = w3;
    w[44][l] = w5;
}

INLINE void rate4(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[19][l]);
    const double w1 = w0 * w[20][l];
    const double w2 = w1 * w[12][l];
    const double w3 = c[23][l] * w2;
    const double w4 = lane_min(w[14][l], w3);
    const double w5 = lane_max(w[21][l], w4);
    const double w6 = (-100000.0) * w5;
    const double w7 = w[22][l] + w6;
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 100000.0 * w5;
    const double w15 = w[22][l] + w14;
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 1e-05 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-1e-05) * w21;
    const double w25 = w23 + w24;
    const double w26 = w[8][l] * w25;
    const double w27 = w26 * w[9][l];
    const double w28 = w27 * w[11][l];
    const double w29 = lane_sin(w[32][l]);
    const double w30 = w29 * w[33][l];
    const double w31 = w30 * w[25][l];
    const double w32 = c[11][l] * w31;
    const double w33 = lane_min(w[27][l], w32);
    const double w34 = lane_max(w[34][l], w33);
    const double w35 = (-100000.0) * w34;
    const double w36 = w[35][l] + w35;
    const double w37 = lane_max(0.0, w36);
    const double w38 = w37 * w37;
    const double w39 = w37 * w38;
    const double w40 = (-0.5) * w37;
    const double w41 = w40 + 1.0;
    const double w42 = w39 * w41;
    const double w43 = 100000.0 * w34;
    const double w44 = w[35][l] + w43;
    const double w45 = lane_max(0.0, w44);
    const double w46 = w45 * w45;
    const double w47 = w45 * w46;
    const double w48 = (-0.5) * w45;
    const double w49 = w48 + 1.0;
    const double w50 = w47 * w49;
    const double w51 = 1e-05 * w42;
    const double w52 = w34 + w51;
    const double w53 = (-1e-05) * w50;
    const double w54 = w52 + w53;
    const double w55 = w[23][l] * w54;
    const double w56 = w55 * w[24][l];
    const double w57 = c[81][l] * w56;
    const double w58 = w[36][l] + w57;
    const double w59 = lane_sin(w[44][l]);
    const double w60 = w59 * w[45][l];
    const double w61 = w60 * w[37][l];
    const double w62 = c[11][l] * w61;
    const double w63 = lane_min(w[39][l], w62);
    const double w64 = lane_max(w[46][l], w63);
    const double w65 = (-100000.0) * w64;
    const double w66 = w[47][l] + w65;
    const double w67 = lane_max(0.0, w66);
    const double w68 = w67 * w67;
    const double w69 = w67 * w68;
    const double w70 = (-0.5) * w67;
    const double w71 = w70 + 1.0;
    const double w72 = w69 * w71;
    const double w73 = 100000.0 * w64;
    const double w74 = w[47][l] + w73;
    const double w75 = lane_max(0.0, w74);
    const double w76 = w75 * w75;
    const double w77 = w75 * w76;
    const double w78 = (-0.5) * w75;
    const double w79 = w78 + 1.0;
    const double w80 = w77 * w79;
    const double w81 = 1e-05 * w72;
    const double w82 = w64 + w81;
    const double w83 = (-1e-05) * w80;
    const double w84 = w82 + w83;
    const double w85 = w[23][l] * w84;
    const double w86 = w85 * w[24][l];
    const double w87 = c[88][l] * w86;
    const double w88 = w[48][l] + w87;
    const double w89 = c[92][l] * w28;
    const double w90 = w[50][l] + w89;
    const double w91 = c[94][l] * w58;
    const double w92 = w90 + w91;
    const double w93 = c[94][l] * w88;
    const double w94 = w92 + w93;
    const double w95 = c[75][l] * w56;
    const double w96 = w[55][l] + w95;
    const double w97 = w27 * w[10][l];
    const double w98 = c[64][l] * w97;
    const double w99 = w[56][l] + w98;
    const double w100 = c[112][l] * w86;
    const double w101 = w[58][l] + w100;
    const double w102 = c[94][l] * w96;
    const double w103 = w101 + w102;
    const double w104 = c[94][l] * w99;
    const double w105 = w103 + w104;
    const double w106 = c[121][l] * w58;
    const double w107 = w[61][l] + w106;
    const double w108 = c[126][l] * w86;
    const double w109 = w107 + w108;
    const double w110 = c[122][l] * w88;
    const double w111 = w109 + w110;
    const double w112 = c[123][l] * w96;
    const double w113 = w111 + w112;
    const double w114 = c[124][l] * w99;
    const double w115 = w113 + w114;
    WRITE(f, S0, w94);
    WRITE(f, S1, w105);
    WRITE(f, S2, w115);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[62];
    LANE_LOOP rate0(c, u, x, f, w, l);
    LANE_LOOP rate1(c, u, x, f, w, l);
    LANE_LOOP rate2(c, u, x, f, w, l);
    LANE_LOOP rate3(c, u, x, f, w, l);
    LANE_LOOP rate4(c, u, x, f, w, l);
}

#if DRIVER == 1
INLINE void turn0(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x2 = MOVE(x, S2);
    const double x5 = MOVE(x, S5);
    const double e0 = MOVE(e, S0);
    const double e1 = MOVE(e, S1);
    const double e2 = MOVE(e, S2);
    const double e5 = MOVE(e, S5);
    const double m0 = MOVE(m, S0);
    const double m1 = MOVE(m, S1);
    const double m2 = MOVE(m, S2);
    const double m5 = MOVE(m, S5);
    const double u0 = u[0][l];
    const double u1 = u[1][l];
    const double u2 = u[2][l];
    const double u3 = u[3][l];
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
    const double w9 = w8 + 0.0001;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = c[37][l] * u2;
    const double w13 = w12 + w11;
    const double w14 = w13 * w13;
    const double w15 = w14 + 1e-08;
    const double w16 = sqrt(w15);
    const double w17 = c[36][l] * u2;
    const double w18 = 0.5 * w11;
    const double w19 = w17 + w18;
    const double w20 = 0.5 * w16;
    const double w21 = w19 + w20;
    const double w22 = sqrt(w21);
    const double w23 = c[1][l] * u3;
    const double w24 = w23 + c[38][l];
    const double w25 = w8 + 1e-08;
    const double w26 = u1 * w1;
    const double w27 = u0 * w3;
    const double w28 = -w27;
    const double w29 = w26 + w28;
    const double w30 = -w29;
    const double w31 = x1 + w30;
    const double w32 = w31 * w31;
    const double w33 = w25 + w32;
    const double w34 = w33 * w7;
    const double w35 = sqrt(w25);
    const double w36 = 1.0 / w35;
    const double w37 = w34 * w36;
    const double w38 = c[45][l] * w37;
    const double w39 = w38 + c[32][l];
    const double w40 = c[3][l] * u3;
    const double w41 = w40 + c[49][l];
    const double w42 = w33 * w41;
    const double w43 = c[50][l] * u2;
    const double w44 = c[48][l] * w42;
    const double w45 = w43 + w44;
    const double w46 = c[15][l] * u6;
    const double w47 = w46 + u7;
    const double w48 = c[56][l] * w47;
    const double w49 = lane_cos(w48);
    const double w50 = x0 * w49;
    const double w51 = c[51][l] * x2;
    const double w52 = x1 + w51;
    const double w53 = lane_sin(w48);
    const double w54 = w52 * w53;
    const double w55 = w50 + w54;
    const double w56 = w55 * w55;
    const double w57 = w52 * w49;
    const double w58 = x0 * w53;
    const double w59 = -w58;
    const double w60 = w57 + w59;
    const double w61 = w60 * w60;
    const double w62 = w56 + w61;
    const double w63 = w62 * w62;
    const double w64 = w63 + c[57][l];
    const double w65 = sqrt(w64);
    const double w66 = sqrt(w65);
    const double w67 = 1.0 / w66;
    const double w68 = w55 * w67;
    const double w69 = w56 + c[61][l];
    const double w70 = sqrt(w69);
    const double w71 = 1.0 / w70;
    const double w72 = w60 * w71;
    const double w73 = w61 + w69;
    const double w74 = sqrt(w73);
    const double w75 = c[46][l] * x2;
    const double w76 = x1 + w75;
    const double w77 = c[70][l] * x0;
    const double w78 = c[71][l] * x2;
    const double w79 = w77 + w78;
    const double w80 = c[69][l] * w76;
    const double w81 = w79 + w80;
    const double w82 = w81 * w81;
    const double w83 = c[72][l] * x0;
    const double w84 = c[73][l] * x2;
    const double w85 = w83 + w84;
    const double w86 = c[70][l] * w76;
    const double w87 = w85 + w86;
    const double w88 = w87 * w87;
    const double w89 = w82 + w88;
    const double w90 = w89 * w89;
    const double w91 = w90 + c[57][l];
    const double w92 = sqrt(w91);
    const double w93 = sqrt(w92);
    const double w94 = 1.0 / w93;
    const double w95 = w81 * w94;
    const double w96 = w82 + c[61][l];
    const double w97 = sqrt(w96);
    const double w98 = 1.0 / w97;
    const double w99 = w87 * w98;
    const double w100 = w88 + w96;
    const double w101 = sqrt(w100);
    const double w102 = c[84][l] * x2;
    const double w103 = w77 + w102;
    const double w104 = c[72][l] * w76;
    const double w105 = w103 + w104;
    const double w106 = w105 * w105;
    const double w107 = c[69][l] * x0;
    const double w108 = c[85][l] * x2;
    const double w109 = w107 + w108;
    const double w110 = w109 + w86;
    const double w111 = w110 * w110;
    const double w112 = w106 + w111;
    const double w113 = w112 * w112;
    const double w114 = w113 + c[57][l];
    const double w115 = sqrt(w114);
    const double w116 = sqrt(w115);
    const double w117 = 1.0 / w116;
    const double w118 = w105 * w117;
    const double w119 = w106 + c[61][l];
    const double w120 = sqrt(w119);
    const double w121 = 1.0 / w120;
    const double w122 = w110 * w121;
    const double w123 = w111 + w119;
    const double w124 = sqrt(w123);
    const double w125 = c[91][l] * u2;
    const double w126 = w125 + w0;
    const double w127 = c[95][l] * w37;
    const double w128 = w126 + w127;
    const double w129 = c[99][l] * x2;
    const double w130 = x1 + w129;
    const double w131 = w130 + w30;
    const double w132 = c[100][l] * u6;
    const double w133 = w132 + u8;
    const double w134 = c[101][l] * w133;
    const double w135 = w131 * w131;
    const double w136 = w21 + w135;
    const double w137 = sqrt(w33);
    const double w138 = w137 * x2;
    const double w139 = c[25][l] * w133;
    const double w140 = x2 * x0;
    const double w141 = c[91][l] * u10;
    const double w142 = -w140;
    const double w143 = w141 + w142;
    const double w144 = c[110][l] * w138;
    const double w145 = w143 + w144;
    const double w146 = c[28][l] * u9;
    const double w147 = c[30][l] * w133;
    const double w148 = w146 + w147;
    const double w149 = c[120][l] * u10;
    const double w150 = c[117][l] * w138;
    const double w151 = w149 + w150;
    const double w152 = x0 * w1;
    const double w153 = x1 * w3;
    const double w154 = -w153;
    const double w155 = w152 + w154;
    const double w156 = x0 * w3;
    const double w157 = x1 * w1;
    const double w158 = w156 + w157;
    const double w159 = x1 * e2;
    const double w160 = x2 * e1;
    const double w161 = w1 * e5;
    const double w162 = u1 * w161;
    const double w163 = w3 * e5;
    const double w164 = u0 * w163;
    const double w165 = -w164;
    const double w166 = w162 + w165;
    const double w167 = -w166;
    const double w168 = e0 + w167;
    const double w169 = w10 * w168;
    const double w170 = w7 * w168;
    const double w171 = 1.0 / w10;
    const double w172 = w170 * w171;
    const double w173 = w7 * w172;
    const double w174 = w169 + w173;
    const double w175 = w13 * w174;
    const double w176 = 1.0 / w16;
    const double w177 = w175 * w176;
    const double w178 = 0.5 * w174;
    const double w179 = 0.5 * w177;
    const double w180 = w178 + w179;
    const double w181 = u1 * w163;
    const double w182 = u0 * w161;
    const double w183 = w181 + w182;
    const double w184 = e1 + w183;
    const double w185 = w31 * w184;
    const double w186 = 2.0 * w170;
    const double w187 = 2.0 * w185;
    const double w188 = w186 + w187;
    const double w189 = w41 * w188;
    const double w190 = c[48][l] * w189;
    const double w191 = w7 * w188;
    const double w192 = w33 * w168;
    const double w193 = c[44][l] * w191;
    const double w194 = c[44][l] * w192;
    const double w195 = w193 + w194;
    const double w196 = w195 * w36;
    const double w197 = w37 * w36;
    const double w198 = w170 * w36;
    const double w199 = w197 * w198;
    const double w200 = c[45][l] * w199;
    const double w201 = w196 + w200;
    const double w202 = w49 * e0;
    const double w203 = c[51][l] * e2;
    const double w204 = e1 + w203;
    const double w205 = w53 * w204;
    const double w206 = w202 + w205;
    const double w207 = w206 * w67;
    const double w208 = w68 * w67;
    const double w209 = w55 * w206;
    const double w210 = w49 * w204;
    const double w211 = w53 * e0;
    const double w212 = -w211;
    const double w213 = w210 + w212;
    const double w214 = w60 * w213;
    const double w215 = 2.0 * w209;
    const double w216 = 2.0 * w214;
    const double w217 = w215 + w216;
    const double w218 = w62 * w217;
    const double w219 = 1.0 / w65;
    const double w220 = w218 * w219;
    const double w221 = w220 * w67;
    const double w222 = w208 * w221;
    const double w223 = (-0.5) * w222;
    const double w224 = w207 + w223;
    const double w225 = w213 * w71;
    const double w226 = w72 * w71;
    const double w227 = w209 * w71;
    const double w228 = w226 * w227;
    const double w229 = -w228;
    const double w230 = w225 + w229;
    const double w231 = 1.0 / w74;
    const double w232 = w217 * w231;
    const double w233 = c[46][l] * e2;
    const double w234 = e1 + w233;
    const double w235 = c[70][l] * e0;
    const double w236 = c[71][l] * e2;
    const double w237 = w235 + w236;
    const double w238 = c[69][l] * w234;
    const double w239 = w237 + w238;
    const double w240 = w239 * w94;
    const double w241 = w95 * w94;
    const double w242 = w81 * w239;
    const double w243 = c[72][l] * e0;
    const double w244 = c[73][l] * e2;
    const double w245 = w243 + w244;
    const double w246 = c[70][l] * w234;
    const double w247 = w245 + w246;
    const double w248 = w87 * w247;
    const double w249 = 2.0 * w242;
    const double w250 = 2.0 * w248;
    const double w251 = w249 + w250;
    const double w252 = w89 * w251;
    const double w253 = 1.0 / w92;
    const double w254 = w252 * w253;
    const double w255 = w254 * w94;
    const double w256 = w241 * w255;
    const double w257 = (-0.5) * w256;
    const double w258 = w240 + w257;
    const double w259 = w247 * w98;
    const double w260 = w99 * w98;
    const double w261 = w242 * w98;
    const double w262 = w260 * w261;
    const double w263 = -w262;
    const double w264 = w259 + w263;
    const double w265 = 1.0 / w101;
    const double w266 = w251 * w265;
    const double w267 = c[84][l] * e2;
    const double w268 = w235 + w267;
    const double w269 = c[72][l] * w234;
    const double w270 = w268 + w269;
    const double w271 = w270 * w117;
    const double w272 = w118 * w117;
    const double w273 = w105 * w270;
    const double w274 = c[69][l] * e0;
    const double w275 = c[85][l] * e2;
    const double w276 = w274 + w275;
    const double w277 = w276 + w246;
    const double w278 = w110 * w277;
    const double w279 = 2.0 * w273;
    const double w280 = 2.0 * w278;
    const double w281 = w279 + w280;
    const double w282 = w112 * w281;
    const double w283 = 1.0 / w115;
    const double w284 = w282 * w283;
    const double w285 = w284 * w117;
    const double w286 = w272 * w285;
    const double w287 = (-0.5) * w286;
    const double w288 = w271 + w287;
    const double w289 = w277 * w121;
    const double w290 = w122 * w121;
    const double w291 = w273 * w121;
    const double w292 = w290 * w291;
    const double w293 = -w292;
    const double w294 = w289 + w293;
    const double w295 = 1.0 / w124;
    const double w296 = w281 * w295;
    const double w297 = c[89][l] * w191;
    const double w298 = c[89][l] * w192;
    const double w299 = w297 + w298;
    const double w300 = w299 * w36;
    const double w301 = w159 + w160;
    const double w302 = c[180][l] * w199;
    const double w303 = w301 + w302;
    const double w304 = c[94][l] * w300;
    const double w305 = w303 + w304;
    const double w306 = 1.0 / w136;
    const double w307 = w22 * w306;
    const double w308 = c[99][l] * e2;
    const double w309 = e1 + w308;
    const double w310 = w309 + w183;
    const double w311 = w307 * w310;
    const double w312 = w131 * w306;
    const double w313 = 1.0 / w22;
    const double w314 = w180 * w313;
    const double w315 = w312 * w314;
    const double w316 = (-0.5) * w315;
    const double w317 = w311 + w316;
    const double w318 = w131 * w310;
    const double w319 = 2.0 * w318;
    const double w320 = w180 + w319;
    const double w321 = 1.0 / w137;
    const double w322 = w188 * w321;
    const double w323 = x2 * w322;
    const double w324 = w137 * e2;
    const double w325 = c[185][l] * w323;
    const double w326 = c[105][l] * w324;
    const double w327 = w325 + w326;
    const double w328 = 1.0 / w33;
    const double w329 = w35 * w328;
    const double w330 = w329 * w184;
    const double w331 = w31 * w328;
    const double w332 = w331 * w198;
    const double w333 = -w332;
    const double w334 = w330 + w333;
    const double w335 = w33 * w334;
    const double w336 = x0 * e2;
    const double w337 = x2 * e0;
    const double w338 = -w336;
    const double w339 = -w337;
    const double w340 = w338 + w339;
    const double w341 = c[187][l] * w327;
    const double w342 = w340 + w341;
    const double w343 = c[188][l] * w335;
    const double w344 = w342 + w343;
    const double w345 = c[190][l] * w327;
    const double w346 = c[191][l] * w335;
    const double w347 = w345 + w346;
    const double w348 = w1 * e0;
    const double w349 = x0 * w163;
    const double w350 = w3 * e1;
    const double w351 = x1 * w161;
    const double w352 = -w349;
    const double w353 = w348 + w352;
    const double w354 = -w350;
    const double w355 = w353 + w354;
    const double w356 = -w351;
    const double w357 = w355 + w356;
    const double w358 = w3 * e0;
    const double w359 = x0 * w161;
    const double w360 = w1 * e1;
    const double w361 = x1 * w163;
    const double w362 = w358 + w359;
    const double w363 = w362 + w360;
    const double w364 = -w361;
    const double w365 = w363 + w364;
    const double w366 = x1 * m2;
    const double w367 = x2 * m1;
    const double w368 = w1 * m5;
    const double w369 = u1 * w368;
    const double w370 = w3 * m5;
    const double w371 = u0 * w370;
    const double w372 = -w371;
    const double w373 = w369 + w372;
    const double w374 = -w373;
    const double w375 = m0 + w374;
    const double w376 = w10 * w375;
    const double w377 = w7 * w375;
    const double w378 = w377 * w171;
    const double w379 = w7 * w378;
    const double w380 = w376 + w379;
    const double w381 = w13 * w380;
    const double w382 = w381 * w176;
    const double w383 = 0.5 * w380;
    const double w384 = 0.5 * w382;
    const double w385 = w383 + w384;
    const double w386 = u1 * w370;
    const double w387 = u0 * w368;
    const double w388 = w386 + w387;
    const double w389 = m1 + w388;
    const double w390 = w31 * w389;
    const double w391 = 2.0 * w377;
    const double w392 = 2.0 * w390;
    const double w393 = w391 + w392;
    const double w394 = w41 * w393;
    const double w395 = c[48][l] * w394;
    const double w396 = w7 * w393;
    const double w397 = w33 * w375;
    const double w398 = c[44][l] * w396;
    const double w399 = c[44][l] * w397;
    const double w400 = w398 + w399;
    const double w401 = w400 * w36;
    const double w402 = w377 * w36;
    const double w403 = w197 * w402;
    const double w404 = c[45][l] * w403;
    const double w405 = w401 + w404;
    const double w406 = w49 * m0;
    const double w407 = c[51][l] * m2;
    const double w408 = m1 + w407;
    const double w409 = w53 * w408;
    const double w410 = w406 + w409;
    const double w411 = w410 * w67;
    const double w412 = w55 * w410;
    const double w413 = w49 * w408;
    const double w414 = w53 * m0;
    const double w415 = -w414;
    const double w416 = w413 + w415;
    const double w417 = w60 * w416;
    const double w418 = 2.0 * w412;
    const double w419 = 2.0 * w417;
    const double w420 = w418 + w419;
    const double w421 = w62 * w420;
    const double w422 = w421 * w219;
    const double w423 = w422 * w67;
    const double w424 = w208 * w423;
    const double w425 = (-0.5) * w424;
    const double w426 = w411 + w425;
    const double w427 = w416 * w71;
    const double w428 = w412 * w71;
    const double w429 = w226 * w428;
    const double w430 = -w429;
    const double w431 = w427 + w430;
    const double w432 = w420 * w231;
    const double w433 = c[46][l] * m2;
    const double w434 = m1 + w433;
    const double w435 = c[70][l] * m0;
    const double w436 = c[71][l] * m2;
    const double w437 = w435 + w436;
    const double w438 = c[69][l] * w434;
    const double w439 = w437 + w438;
    const double w440 = w439 * w94;
    const double w441 = w81 * w439;
    const double w442 = c[72][l] * m0;
    const double w443 = c[73][l] * m2;
    const double w444 = w442 + w443;
    const double w445 = c[70][l] * w434;
    const double w446 = w444 + w445;
    const double w447 = w87 * w446;
    const double w448 = 2.0 * w441;
    const double w449 = 2.0 * w447;
    const double w450 = w448 + w449;
    const double w451 = w89 * w450;
    const double w452 = w451 * w253;
    const double w453 = w452 * w94;
    const double w454 = w241 * w453;
    const double w455 = (-0.5) * w454;
    const double w456 = w440 + w455;
    const double w457 = w446 * w98;
    const double w458 = w441 * w98;
    const double w459 = w260 * w458;
    const double w460 = -w459;
    const double w461 = w457 + w460;
    const double w462 = w450 * w265;
    const double w463 = c[84][l] * m2;
    const double w464 = w435 + w463;
    const double w465 = c[72][l] * w434;
    const double w466 = w464 + w465;
    const double w467 = w466 * w117;
    const double w468 = w105 * w466;
    const double w469 = c[69][l] * m0;
    const double w470 = c[85][l] * m2;
    const double w471 = w469 + w470;
    const double w472 = w471 + w445;
    const double w473 = w110 * w472;
    const double w474 = 2.0 * w468;
    const double w475 = 2.0 * w473;
    const double w476 = w474 + w475;
    const double w477 = w112 * w476;
    const double w478 = w477 * w283;
    const double w479 = w478 * w117;
    const double w480 = w272 * w479;
    const double w481 = (-0.5) * w480;
    const double w482 = w467 + w481;
    const double w483 = w472 * w121;
    const double w484 = w468 * w121;
    const double w485 = w290 * w484;
    const double w486 = -w485;
    const double w487 = w483 + w486;
    const double w488 = w476 * w295;
    const double w489 = c[89][l] * w396;
    const double w490 = c[89][l] * w397;
    const double w491 = w489 + w490;
    const double w492 = w491 * w36;
    const double w493 = w366 + w367;
    const double w494 = c[180][l] * w403;
    const double w495 = w493 + w494;
    const double w496 = c[94][l] * w492;
    const double w497 = w495 + w496;
    const double w498 = c[99][l] * m2;
    const double w499 = m1 + w498;
    const double w500 = w499 + w388;
    const double w501 = w307 * w500;
    const double w502 = w385 * w313;
    const double w503 = w312 * w502;
    const double w504 = (-0.5) * w503;
    const double w505 = w501 + w504;
    const double w506 = w131 * w500;
    const double w507 = 2.0 * w506;
    const double w508 = w385 + w507;
    const double w509 = w393 * w321;
    const double w510 = x2 * w509;
    const double w511 = w137 * m2;
    const double w512 = c[185][l] * w510;
    const double w513 = c[105][l] * w511;
    const double w514 = w512 + w513;
    const double w515 = w329 * w389;
    const double w516 = w331 * w402;
    const double w517 = -w516;
    const double w518 = w515 + w517;
    const double w519 = w33 * w518;
    const double w520 = x0 * m2;
    const double w521 = x2 * m0;
    const double w522 = -w520;
    const double w523 = -w521;
    const double w524 = w522 + w523;
    const double w525 = c[187][l] * w514;
    const double w526 = w524 + w525;
    const double w527 = c[188][l] * w519;
    const double w528 = w526 + w527;
    const double w529 = c[190][l] * w514;
    const double w530 = c[191][l] * w519;
    const double w531 = w529 + w530;
    const double w532 = w1 * m0;
    const double w533 = x0 * w370;
    const double w534 = w3 * m1;
    const double w535 = x1 * w368;
    const double w536 = -w533;
    const double w537 = w532 + w536;
    const double w538 = -w534;
    const double w539 = w537 + w538;
    const double w540 = -w535;
    const double w541 = w539 + w540;
    const double w542 = w3 * m0;
    const double w543 = x0 * w368;
    const double w544 = w1 * m1;
    const double w545 = x1 * w370;
    const double w546 = w542 + w543;
    const double w547 = w546 + w544;
    const double w548 = -w545;
    const double w549 = w547 + w548;
    w[0][l] = w21;
    w[1][l] = w22;
    w[2][l] = w24;
    w[3][l] = w31;
    w[4][l] = w33;
    w[5][l] = w35;
    w[6][l] = w39;
    w[7][l] = w45;
    w[10][l] = w49;
    w[11][l] = w53;
    w[12][l] = w67;
    w[13][l] = w68;
    w[15][l] = w72;
    w[20][l] = w74;
    w[25][l] = w94;
    w[26][l] = w95;
    w[28][l] = w99;
    w[33][l] = w101;
    w[37][l] = w117;
    w[38][l] = w118;
    w[40][l] = w122;
    w[45][l] = w124;
    w[49][l] = w128;
    w[51][l] = w131;
    w[52][l] = w134;
    w[53][l] = w136;
    w[54][l] = w139;
    w[57][l] = w145;
    w[59][l] = w148;
    w[60][l] = w151;
    w[62][l] = w180;
    w[63][l] = w188;
    w[64][l] = w190;
    w[65][l] = w201;
    w[68][l] = w221;
    w[69][l] = w224;
    w[71][l] = w230;
    w[74][l] = w232;
    w[79][l] = w255;
    w[80][l] = w258;
    w[82][l] = w264;
    w[85][l] = w266;
    w[89][l] = w285;
    w[90][l] = w288;
    w[92][l] = w294;
    w[95][l] = w296;
    w[99][l] = w305;
    w[101][l] = w317;
    w[102][l] = w320;
    w[105][l] = w344;
    w[107][l] = w347;
    w[109][l] = w385;
    w[110][l] = w393;
    w[111][l] = w395;
    w[112][l] = w405;
    w[115][l] = w423;
    w[116][l] = w426;
    w[118][l] = w431;
    w[121][l] = w432;
    w[126][l] = w453;
    w[127][l] = w456;
    w[129][l] = w461;
    w[132][l] = w462;
    w[136][l] = w479;
    w[137][l] = w482;
    w[139][l] = w487;
    w[142][l] = w488;
    w[146][l] = w497;
    w[148][l] = w505;
    w[149][l] = w508;
    w[152][l] = w528;
    w[154][l] = w531;
    WRITE(f, S3, w155);
    WRITE(f, S4, w158);
    WRITE(f, S5, x2);
    WRITE(r, S3, w357);
    WRITE(r, S4, w365);
    WRITE(r, S5, e2);
    WRITE_MOVING(g, S3, w541);
    WRITE_MOVING(g, S4, w549);
    WRITE_MOVING(g, S5, m2);
}

INLINE void turn1(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
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
    const double w7 = w6 + c[39][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[39][l];
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
    const double w27 = c[41][l] * w26;
    const double w28 = w[6][l] + w27;
    const double w29 = c[47][l] * w26;
    const double w30 = w[7][l] + w29;
    const double w31 = c[46][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[53][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[19][l] * w34;
    const double w36 = w35 + c[18][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[55][l] * w38;
    const double w40 = w39 + 5e-06;
    const double w41 = lane_min(w40, w[13][l]);
    const double w42 = -w40;
    const double w43 = lane_max(w42, w41);
    const double w44 = c[58][l] * w38;
    const double w45 = w44 + 0.5;
    const double w46 = (-100000.0) * w43;
    const double w47 = w45 + w46;
    const double w48 = lane_max(0.0, w47);
    const double w49 = w48 * w48;
    const double w50 = w48 * w49;
    const double w51 = (-0.5) * w48;
    const double w52 = w51 + 1.0;
    const double w53 = w50 * w52;
    const double w54 = 100000.0 * w43;
    const double w55 = w45 + w54;
    const double w56 = lane_max(0.0, w55);
    const double w57 = w56 * w56;
    const double w58 = w56 * w57;
    const double w59 = (-0.5) * w56;
    const double w60 = w59 + 1.0;
    const double w61 = w58 * w60;
    const double w62 = 1e-05 * w53;
    const double w63 = w43 + w62;
    const double w64 = (-1e-05) * w61;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = -w66;
    const double w68 = w67 + 1.0;
    const double w69 = sqrt(w68);
    const double w70 = w69 + 5e-06;
    const double w71 = c[17][l] * w34;
    const double w72 = w71 + c[16][l];
    const double w73 = lane_max(0.0, w72);
    const double w74 = w73 * w[15][l];
    const double w75 = w74 * w38;
    const double w76 = c[54][l] * w75;
    const double w77 = lane_min(w76, c[59][l]);
    const double w78 = lane_max(c[60][l], w77);
    const double w79 = c[21][l] * w78;
    const double w80 = c[63][l] * w78;
    const double w81 = -w70;
    const double w82 = (-100000.0) * w69;
    const double w83 = w82 + 0.5;
    const double w84 = w34 * w65;
    const double w85 = w84 * w37;
    const double w86 = w85 * w[10][l];
    const double w87 = c[51][l] * w28;
    const double w88 = w87 + w30;
    const double w89 = c[66][l] * w88;
    const double w90 = lane_max(0.0, w89);
    const double w91 = c[7][l] * w90;
    const double w92 = w91 + c[6][l];
    const double w93 = lane_max(0.001, w92);
    const double w94 = c[8][l] * w93;
    const double w95 = w94 + c[67][l];
    const double w96 = u4 * w95;
    const double w97 = 1.0 / w93;
    const double w98 = w96 + c[12][l];
    const double w99 = w98 * w97;
    const double w100 = c[68][l] * w99;
    const double w101 = w100 + 5e-06;
    const double w102 = lane_min(w101, w[26][l]);
    const double w103 = -w101;
    const double w104 = lane_max(w103, w102);
    const double w105 = c[74][l] * w99;
    const double w106 = w105 + 0.5;
    const double w107 = (-100000.0) * w104;
    const double w108 = w106 + w107;
    const double w109 = lane_max(0.0, w108);
    const double w110 = w109 * w109;
    const double w111 = w109 * w110;
    const double w112 = (-0.5) * w109;
    const double w113 = w112 + 1.0;
    const double w114 = w111 * w113;
    const double w115 = 100000.0 * w104;
    const double w116 = w106 + w115;
    const double w117 = lane_max(0.0, w116);
    const double w118 = w117 * w117;
    const double w119 = w117 * w118;
    const double w120 = (-0.5) * w117;
    const double w121 = w120 + 1.0;
    const double w122 = w119 * w121;
    const double w123 = 1e-05 * w114;
    const double w124 = w104 + w123;
    const double w125 = (-1e-05) * w122;
    const double w126 = w124 + w125;
    const double w127 = w90 * w126;
    const double w128 = w127 * w93;
    const double w129 = w126 * w126;
    const double w130 = -w129;
    const double w131 = w130 + 1.0;
    const double w132 = sqrt(w131);
    const double w133 = w132 + 5e-06;
    const double w134 = c[5][l] * w90;
    const double w135 = w134 + c[4][l];
    const double w136 = lane_max(0.0, w135);
    const double w137 = w136 * w[28][l];
    const double w138 = w137 * w97;
    const double w139 = c[68][l] * w138;
    const double w140 = lane_min(w139, c[76][l]);
    const double w141 = lane_max(c[77][l], w140);
    const double w142 = c[9][l] * w141;
    const double w143 = c[78][l] * w141;
    const double w144 = -w133;
    const double w145 = (-100000.0) * w132;
    const double w146 = w145 + 0.5;
    const double w147 = c[75][l] * w128;
    const double w148 = c[13][l] * w93;
    const double w149 = w148 + c[82][l];
    const double w150 = u5 * w149;
    const double w151 = w150 + c[14][l];
    const double w152 = w151 * w97;
    const double w153 = c[83][l] * w152;
    const double w154 = w153 + 5e-06;
    const double w155 = lane_min(w154, w[38][l]);
    const double w156 = -w154;
    const double w157 = lane_max(w156, w155);
    const double w158 = c[86][l] * w152;
    const double w159 = w158 + 0.5;
    const double w160 = (-100000.0) * w157;
    const double w161 = w159 + w160;
    const double w162 = lane_max(0.0, w161);
    const double w163 = w162 * w162;
    const double w164 = w162 * w163;
    const double w165 = (-0.5) * w162;
    const double w166 = w165 + 1.0;
    const double w167 = w164 * w166;
    const double w168 = 100000.0 * w157;
    const double w169 = w159 + w168;
    const double w170 = lane_max(0.0, w169);
    const double w171 = w170 * w170;
    const double w172 = w170 * w171;
    const double w173 = (-0.5) * w170;
    const double w174 = w173 + 1.0;
    const double w175 = w172 * w174;
    const double w176 = 1e-05 * w167;
    const double w177 = w157 + w176;
    const double w178 = (-1e-05) * w175;
    const double w179 = w177 + w178;
    const double w180 = w90 * w179;
    const double w181 = w180 * w93;
    const double w182 = w179 * w179;
    const double w183 = -w182;
    const double w184 = w183 + 1.0;
    const double w185 = sqrt(w184);
    const double w186 = w185 + 5e-06;
    const double w187 = w136 * w[40][l];
    const double w188 = w187 * w97;
    const double w189 = c[83][l] * w188;
    const double w190 = lane_min(w189, c[76][l]);
    const double w191 = lane_max(c[77][l], w190);
    const double w192 = c[9][l] * w191;
    const double w193 = c[78][l] * w191;
    const double w194 = -w186;
    const double w195 = (-100000.0) * w185;
    const double w196 = w195 + 0.5;
    const double w197 = c[87][l] * w181;
    const double w198 = c[93][l] * w86;
    const double w199 = w[49][l] + w198;
    const double w200 = lane_atan2(w[51][l], w[1][l]);
    const double w201 = w[52][l] + w200;
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
    const double w225 = w224 * w[53][l];
    const double w226 = lane_atan2(w[3][l], w[5][l]);
    const double w227 = c[24][l] * w226;
    const double w228 = w[54][l] + w227;
    const double w229 = w[4][l] * w228;
    const double w230 = c[80][l] * w128;
    const double w231 = w85 * w[11][l];
    const double w232 = c[20][l] * w231;
    const double w233 = c[109][l] * w181;
    const double w234 = w[57][l] + w233;
    const double w235 = c[108][l] * w225;
    const double w236 = w234 + w235;
    const double w237 = c[111][l] * w229;
    const double w238 = w236 + w237;
    const double w239 = c[29][l] * w226;
    const double w240 = w[59][l] + w239;
    const double w241 = w[4][l] * w240;
    const double w242 = c[125][l] * w181;
    const double w243 = w[60][l] + w242;
    const double w244 = c[119][l] * w225;
    const double w245 = w243 + w244;
    const double w246 = c[118][l] * w241;
    const double w247 = w245 + w246;
    const double w248 = 0.0 <= w33 ? 1.0 : 0.0;
    const double w249 = w33 <= 0.0 ? 1.0 : 0.0;
    const double w250 = w248 + w249;
    const double w251 = 1.0 / w250;
    const double w252 = w248 * w251;
    const double w253 = w25 * w[62][l];
    const double w254 = c[47][l] * w253;
    const double w255 = w[64][l] + w254;
    const double w256 = c[40][l] * w253;
    const double w257 = w[65][l] + w256;
    const double w258 = c[116][l] * w257;
    const double w259 = w255 + w258;
    const double w260 = w252 * w259;
    const double w261 = w41 <= w42 ? 1.0 : 0.0;
    const double w262 = w42 <= w41 ? 1.0 : 0.0;
    const double w263 = w261 + w262;
    const double w264 = 1.0 / w263;
    const double w265 = w261 * w264;
    const double w266 = w38 * w38;
    const double w267 = 0.001 <= w36 ? 1.0 : 0.0;
    const double w268 = w36 <= 0.001 ? 1.0 : 0.0;
    const double w269 = w267 + w268;
    const double w270 = 1.0 / w269;
    const double w271 = w267 * w270;
    const double w272 = w271 * w260;
    const double w273 = w266 * w272;
    const double w274 = w265 * w273;
    const double w275 = w262 * w264;
    const double w276 = w[13][l] <= w40 ? 1.0 : 0.0;
    const double w277 = w40 <= w[13][l] ? 1.0 : 0.0;
    const double w278 = w276 + w277;
    const double w279 = 1.0 / w278;
    const double w280 = w276 * w279;
    const double w281 = w280 * w[69][l];
    const double w282 = w277 * w279;
    const double w283 = w282 * w273;
    const double w284 = c[156][l] * w283;
    const double w285 = w281 + w284;
    const double w286 = w275 * w285;
    const double w287 = c[155][l] * w274;
    const double w288 = w287 + w286;
    const double w289 = 0.0 <= w47 ? 1.0 : 0.0;
    const double w290 = w47 <= 0.0 ? 1.0 : 0.0;
    const double w291 = w289 + w290;
    const double w292 = 1.0 / w291;
    const double w293 = w289 * w292;
    const double w294 = c[157][l] * w273;
    const double w295 = 100000.0 * w288;
    const double w296 = w294 + w295;
    const double w297 = w293 * w296;
    const double w298 = w50 * w297;
    const double w299 = w49 * w297;
    const double w300 = w48 * w297;
    const double w301 = w48 * w300;
    const double w302 = 2.0 * w301;
    const double w303 = w299 + w302;
    const double w304 = w52 * w303;
    const double w305 = 0.0 <= w55 ? 1.0 : 0.0;
    const double w306 = w55 <= 0.0 ? 1.0 : 0.0;
    const double w307 = w305 + w306;
    const double w308 = 1.0 / w307;
    const double w309 = w305 * w308;
    const double w310 = c[158][l] * w273;
    const double w311 = w310 + w295;
    const double w312 = w309 * w311;
    const double w313 = w57 * w312;
    const double w314 = w56 * w312;
    const double w315 = w56 * w314;
    const double w316 = 2.0 * w315;
    const double w317 = w313 + w316;
    const double w318 = w60 * w317;
    const double w319 = w58 * w312;
    const double w320 = 5e-06 * w298;
    const double w321 = w288 + w320;
    const double w322 = (-1e-05) * w304;
    const double w323 = w321 + w322;
    const double w324 = (-1e-05) * w318;
    const double w325 = w323 + w324;
    const double w326 = 5e-06 * w319;
    const double w327 = w325 + w326;
    const double w328 = w65 * w327;
    const double w329 = 1.0 / w69;
    const double w330 = w328 * w329;
    const double w331 = c[60][l] <= w77 ? 1.0 : 0.0;
    const double w332 = w77 <= c[60][l] ? 1.0 : 0.0;
    const double w333 = w331 + w332;
    const double w334 = 1.0 / w333;
    const double w335 = w331 * w334;
    const double w336 = w76 <= c[59][l] ? 1.0 : 0.0;
    const double w337 = c[59][l] <= w76 ? 1.0 : 0.0;
    const double w338 = w336 + w337;
    const double w339 = 1.0 / w338;
    const double w340 = w336 * w339;
    const double w341 = 0.0 <= w72 ? 1.0 : 0.0;
    const double w342 = w72 <= 0.0 ? 1.0 : 0.0;
    const double w343 = w341 + w342;
    const double w344 = 1.0 / w343;
    const double w345 = w341 * w344;
    const double w346 = w345 * w260;
    const double w347 = w[15][l] * w346;
    const double w348 = w73 * w[71][l];
    const double w349 = c[159][l] * w347;
    const double w350 = w349 + w348;
    const double w351 = w350 * w38;
    const double w352 = w75 * w38;
    const double w353 = w352 * w272;
    const double w354 = c[54][l] * w351;
    const double w355 = c[160][l] * w353;
    const double w356 = w354 + w355;
    const double w357 = w340 * w356;
    const double w358 = w335 * w357;
    const double w359 = w78 * w78;
    const double w360 = c[161][l] * w359;
    const double w361 = w360 + 1.0;
    const double w362 = 1.0 / w361;
    const double w363 = w358 * w362;
    const double w364 = c[63][l] * w358;
    const double w365 = c[162][l] * w363;
    const double w366 = w364 + w365;
    const double w367 = (-100000.0) * w330;
    const double w368 = 100000.0 * w330;
    const double w369 = w65 * w260;
    const double w370 = w34 * w327;
    const double w371 = c[53][l] * w369;
    const double w372 = w371 + w370;
    const double w373 = w37 * w372;
    const double w374 = w84 * w272;
    const double w375 = c[20][l] * w373;
    const double w376 = c[154][l] * w374;
    const double w377 = w375 + w376;
    const double w378 = w[10][l] * w377;
    const double w379 = w103 <= w102 ? 1.0 : 0.0;
    const double w380 = w102 <= w103 ? 1.0 : 0.0;
    const double w381 = w379 + w380;
    const double w382 = 1.0 / w381;
    const double w383 = w379 * w382;
    const double w384 = w101 <= w[26][l] ? 1.0 : 0.0;
    const double w385 = w[26][l] <= w101 ? 1.0 : 0.0;
    const double w386 = w384 + w385;
    const double w387 = 1.0 / w386;
    const double w388 = w384 * w387;
    const double w389 = w99 * w97;
    const double w390 = 0.001 <= w92 ? 1.0 : 0.0;
    const double w391 = w92 <= 0.001 ? 1.0 : 0.0;
    const double w392 = w390 + w391;
    const double w393 = 1.0 / w392;
    const double w394 = w390 * w393;
    const double w395 = 0.0 <= w89 ? 1.0 : 0.0;
    const double w396 = w89 <= 0.0 ? 1.0 : 0.0;
    const double w397 = w395 + w396;
    const double w398 = 1.0 / w397;
    const double w399 = w395 * w398;
    const double w400 = c[52][l] * w257;
    const double w401 = w255 + w400;
    const double w402 = w399 * w401;
    const double w403 = w394 * w402;
    const double w404 = w389 * w403;
    const double w405 = u4 * w403;
    const double w406 = w405 * w97;
    const double w407 = c[166][l] * w404;
    const double w408 = c[167][l] * w406;
    const double w409 = w407 + w408;
    const double w410 = w388 * w409;
    const double w411 = w385 * w387;
    const double w412 = w411 * w[80][l];
    const double w413 = w410 + w412;
    const double w414 = w383 * w413;
    const double w415 = w380 * w382;
    const double w416 = w415 * w409;
    const double w417 = -w416;
    const double w418 = w414 + w417;
    const double w419 = 0.0 <= w108 ? 1.0 : 0.0;
    const double w420 = w108 <= 0.0 ? 1.0 : 0.0;
    const double w421 = w419 + w420;
    const double w422 = 1.0 / w421;
    const double w423 = w419 * w422;
    const double w424 = (-100000.0) * w409;
    const double w425 = (-100000.0) * w418;
    const double w426 = w424 + w425;
    const double w427 = w423 * w426;
    const double w428 = w110 * w427;
    const double w429 = w109 * w427;
    const double w430 = w109 * w429;
    const double w431 = 2.0 * w430;
    const double w432 = w428 + w431;
    const double w433 = w113 * w432;
    const double w434 = w111 * w427;
    const double w435 = 0.0 <= w116 ? 1.0 : 0.0;
    const double w436 = w116 <= 0.0 ? 1.0 : 0.0;
    const double w437 = w435 + w436;
    const double w438 = 1.0 / w437;
    const double w439 = w435 * w438;
    const double w440 = 100000.0 * w418;
    const double w441 = w424 + w440;
    const double w442 = w439 * w441;
    const double w443 = w118 * w442;
    const double w444 = w117 * w442;
    const double w445 = w117 * w444;
    const double w446 = 2.0 * w445;
    const double w447 = w443 + w446;
    const double w448 = w121 * w447;
    const double w449 = w119 * w442;
    const double w450 = 1e-05 * w433;
    const double w451 = w418 + w450;
    const double w452 = (-5e-06) * w434;
    const double w453 = w451 + w452;
    const double w454 = (-1e-05) * w448;
    const double w455 = w453 + w454;
    const double w456 = 5e-06 * w449;
    const double w457 = w455 + w456;
    const double w458 = w90 * w457;
    const double w459 = w126 * w402;
    const double w460 = c[66][l] * w459;
    const double w461 = w458 + w460;
    const double w462 = w93 * w461;
    const double w463 = w127 * w403;
    const double w464 = c[8][l] * w462;
    const double w465 = c[168][l] * w463;
    const double w466 = w464 + w465;
    const double w467 = w126 * w457;
    const double w468 = 1.0 / w132;
    const double w469 = w467 * w468;
    const double w470 = c[77][l] <= w140 ? 1.0 : 0.0;
    const double w471 = w140 <= c[77][l] ? 1.0 : 0.0;
    const double w472 = w470 + w471;
    const double w473 = 1.0 / w472;
    const double w474 = w470 * w473;
    const double w475 = w139 <= c[76][l] ? 1.0 : 0.0;
    const double w476 = c[76][l] <= w139 ? 1.0 : 0.0;
    const double w477 = w475 + w476;
    const double w478 = 1.0 / w477;
    const double w479 = w475 * w478;
    const double w480 = w136 * w[82][l];
    const double w481 = 0.0 <= w135 ? 1.0 : 0.0;
    const double w482 = w135 <= 0.0 ? 1.0 : 0.0;
    const double w483 = w481 + w482;
    const double w484 = 1.0 / w483;
    const double w485 = w481 * w484;
    const double w486 = w485 * w402;
    const double w487 = w[28][l] * w486;
    const double w488 = c[170][l] * w487;
    const double w489 = w480 + w488;
    const double w490 = w489 * w97;
    const double w491 = w138 * w97;
    const double w492 = w491 * w403;
    const double w493 = c[68][l] * w490;
    const double w494 = c[166][l] * w492;
    const double w495 = w493 + w494;
    const double w496 = w479 * w495;
    const double w497 = w474 * w496;
    const double w498 = w141 * w141;
    const double w499 = c[171][l] * w498;
    const double w500 = w499 + 1.0;
    const double w501 = 1.0 / w500;
    const double w502 = w497 * w501;
    const double w503 = c[78][l] * w497;
    const double w504 = c[172][l] * w502;
    const double w505 = w503 + w504;
    const double w506 = (-100000.0) * w469;
    const double w507 = 100000.0 * w469;
    const double w508 = c[70][l] * w466;
    const double w509 = w156 <= w155 ? 1.0 : 0.0;
    const double w510 = w155 <= w156 ? 1.0 : 0.0;
    const double w511 = w509 + w510;
    const double w512 = 1.0 / w511;
    const double w513 = w509 * w512;
    const double w514 = w154 <= w[38][l] ? 1.0 : 0.0;
    const double w515 = w[38][l] <= w154 ? 1.0 : 0.0;
    const double w516 = w514 + w515;
    const double w517 = 1.0 / w516;
    const double w518 = w514 * w517;
    const double w519 = w152 * w97;
    const double w520 = w519 * w403;
    const double w521 = u5 * w403;
    const double w522 = w521 * w97;
    const double w523 = c[176][l] * w520;
    const double w524 = c[177][l] * w522;
    const double w525 = w523 + w524;
    const double w526 = w518 * w525;
    const double w527 = w515 * w517;
    const double w528 = w527 * w[90][l];
    const double w529 = w526 + w528;
    const double w530 = w513 * w529;
    const double w531 = w510 * w512;
    const double w532 = w531 * w525;
    const double w533 = -w532;
    const double w534 = w530 + w533;
    const double w535 = 0.0 <= w161 ? 1.0 : 0.0;
    const double w536 = w161 <= 0.0 ? 1.0 : 0.0;
    const double w537 = w535 + w536;
    const double w538 = 1.0 / w537;
    const double w539 = w535 * w538;
    const double w540 = (-100000.0) * w525;
    const double w541 = (-100000.0) * w534;
    const double w542 = w540 + w541;
    const double w543 = w539 * w542;
    const double w544 = w163 * w543;
    const double w545 = w162 * w543;
    const double w546 = w162 * w545;
    const double w547 = 2.0 * w546;
    const double w548 = w544 + w547;
    const double w549 = w166 * w548;
    const double w550 = w164 * w543;
    const double w551 = 0.0 <= w169 ? 1.0 : 0.0;
    const double w552 = w169 <= 0.0 ? 1.0 : 0.0;
    const double w553 = w551 + w552;
    const double w554 = 1.0 / w553;
    const double w555 = w551 * w554;
    const double w556 = 100000.0 * w534;
    const double w557 = w540 + w556;
    const double w558 = w555 * w557;
    const double w559 = w171 * w558;
    const double w560 = w170 * w558;
    const double w561 = w170 * w560;
    const double w562 = 2.0 * w561;
    const double w563 = w559 + w562;
    const double w564 = w174 * w563;
    const double w565 = w172 * w558;
    const double w566 = 1e-05 * w549;
    const double w567 = w534 + w566;
    const double w568 = (-5e-06) * w550;
    const double w569 = w567 + w568;
    const double w570 = (-1e-05) * w564;
    const double w571 = w569 + w570;
    const double w572 = 5e-06 * w565;
    const double w573 = w571 + w572;
    const double w574 = w90 * w573;
    const double w575 = w179 * w402;
    const double w576 = c[66][l] * w575;
    const double w577 = w574 + w576;
    const double w578 = w93 * w577;
    const double w579 = w180 * w403;
    const double w580 = c[13][l] * w578;
    const double w581 = c[178][l] * w579;
    const double w582 = w580 + w581;
    const double w583 = w179 * w573;
    const double w584 = 1.0 / w185;
    const double w585 = w583 * w584;
    const double w586 = c[77][l] <= w190 ? 1.0 : 0.0;
    const double w587 = w190 <= c[77][l] ? 1.0 : 0.0;
    const double w588 = w586 + w587;
    const double w589 = 1.0 / w588;
    const double w590 = w586 * w589;
    const double w591 = w189 <= c[76][l] ? 1.0 : 0.0;
    const double w592 = c[76][l] <= w189 ? 1.0 : 0.0;
    const double w593 = w591 + w592;
    const double w594 = 1.0 / w593;
    const double w595 = w591 * w594;
    const double w596 = w136 * w[92][l];
    const double w597 = w[40][l] * w486;
    const double w598 = c[170][l] * w597;
    const double w599 = w596 + w598;
    const double w600 = w599 * w97;
    const double w601 = w188 * w97;
    const double w602 = w601 * w403;
    const double w603 = c[83][l] * w600;
    const double w604 = c[176][l] * w602;
    const double w605 = w603 + w604;
    const double w606 = w595 * w605;
    const double w607 = w590 * w606;
    const double w608 = w191 * w191;
    const double w609 = c[171][l] * w608;
    const double w610 = w609 + 1.0;
    const double w611 = 1.0 / w610;
    const double w612 = w607 * w611;
    const double w613 = c[78][l] * w607;
    const double w614 = c[172][l] * w612;
    const double w615 = w613 + w614;
    const double w616 = (-100000.0) * w585;
    const double w617 = 100000.0 * w585;
    const double w618 = c[70][l] * w582;
    const double w619 = c[94][l] * w378;
    const double w620 = w[99][l] + w619;
    const double w621 = c[97][l] <= w203 ? 1.0 : 0.0;
    const double w622 = w203 <= c[97][l] ? 1.0 : 0.0;
    const double w623 = w621 + w622;
    const double w624 = 1.0 / w623;
    const double w625 = w621 * w624;
    const double w626 = w202 <= c[96][l] ? 1.0 : 0.0;
    const double w627 = c[96][l] <= w202 ? 1.0 : 0.0;
    const double w628 = w626 + w627;
    const double w629 = 1.0 / w628;
    const double w630 = w626 * w629;
    const double w631 = w630 * w[101][l];
    const double w632 = w625 * w631;
    const double w633 = 0.0 <= w206 ? 1.0 : 0.0;
    const double w634 = w206 <= 0.0 ? 1.0 : 0.0;
    const double w635 = w633 + w634;
    const double w636 = 1.0 / w635;
    const double w637 = w633 * w636;
    const double w638 = w637 * w632;
    const double w639 = w209 * w638;
    const double w640 = w208 * w638;
    const double w641 = w207 * w638;
    const double w642 = w207 * w641;
    const double w643 = c[181][l] * w640;
    const double w644 = c[183][l] * w642;
    const double w645 = w643 + w644;
    const double w646 = w211 * w645;
    const double w647 = 0.0 <= w214 ? 1.0 : 0.0;
    const double w648 = w214 <= 0.0 ? 1.0 : 0.0;
    const double w649 = w647 + w648;
    const double w650 = 1.0 / w649;
    const double w651 = w647 * w650;
    const double w652 = w651 * w632;
    const double w653 = w216 * w652;
    const double w654 = w215 * w652;
    const double w655 = w215 * w654;
    const double w656 = c[181][l] * w653;
    const double w657 = c[183][l] * w655;
    const double w658 = w656 + w657;
    const double w659 = w219 * w658;
    const double w660 = w217 * w652;
    const double w661 = c[31][l] * w632;
    const double w662 = c[182][l] * w639;
    const double w663 = w661 + w662;
    const double w664 = (-0.2) * w646;
    const double w665 = w663 + w664;
    const double w666 = (-0.2) * w659;
    const double w667 = w665 + w666;
    const double w668 = c[184][l] * w660;
    const double w669 = w667 + w668;
    const double w670 = w[53][l] * w669;
    const double w671 = w224 * w[102][l];
    const double w672 = c[103][l] * w670;
    const double w673 = c[103][l] * w671;
    const double w674 = w672 + w673;
    const double w675 = w228 * w[63][l];
    const double w676 = c[69][l] * w466;
    const double w677 = w[11][l] * w377;
    const double w678 = c[186][l] * w582;
    const double w679 = w[105][l] + w678;
    const double w680 = c[94][l] * w674;
    const double w681 = w679 + w680;
    const double w682 = c[111][l] * w675;
    const double w683 = w681 + w682;
    const double w684 = w240 * w[63][l];
    const double w685 = c[193][l] * w582;
    const double w686 = w[107][l] + w685;
    const double w687 = c[192][l] * w674;
    const double w688 = w686 + w687;
    const double w689 = c[118][l] * w684;
    const double w690 = w688 + w689;
    const double w691 = w25 * w[109][l];
    const double w692 = c[47][l] * w691;
    const double w693 = w[111][l] + w692;
    const double w694 = c[40][l] * w691;
    const double w695 = w[112][l] + w694;
    const double w696 = c[116][l] * w695;
    const double w697 = w693 + w696;
    const double w698 = w252 * w697;
    const double w699 = w271 * w698;
    const double w700 = w266 * w699;
    const double w701 = w265 * w700;
    const double w702 = w280 * w[116][l];
    const double w703 = w282 * w700;
    const double w704 = c[156][l] * w703;
    const double w705 = w702 + w704;
    const double w706 = w275 * w705;
    const double w707 = c[155][l] * w701;
    const double w708 = w707 + w706;
    const double w709 = c[157][l] * w700;
    const double w710 = 100000.0 * w708;
    const double w711 = w709 + w710;
    const double w712 = w293 * w711;
    const double w713 = w50 * w712;
    const double w714 = w49 * w712;
    const double w715 = w48 * w712;
    const double w716 = w48 * w715;
    const double w717 = 2.0 * w716;
    const double w718 = w714 + w717;
    const double w719 = w52 * w718;
    const double w720 = c[158][l] * w700;
    const double w721 = w720 + w710;
    const double w722 = w309 * w721;
    const double w723 = w57 * w722;
    const double w724 = w56 * w722;
    const double w725 = w56 * w724;
    const double w726 = 2.0 * w725;
    const double w727 = w723 + w726;
    const double w728 = w60 * w727;
    const double w729 = w58 * w722;
    const double w730 = 5e-06 * w713;
    const double w731 = w708 + w730;
    const double w732 = (-1e-05) * w719;
    const double w733 = w731 + w732;
    const double w734 = (-1e-05) * w728;
    const double w735 = w733 + w734;
    const double w736 = 5e-06 * w729;
    const double w737 = w735 + w736;
    const double w738 = w65 * w737;
    const double w739 = w738 * w329;
    const double w740 = w345 * w698;
    const double w741 = w[15][l] * w740;
    const double w742 = w73 * w[118][l];
    const double w743 = c[159][l] * w741;
    const double w744 = w743 + w742;
    const double w745 = w744 * w38;
    const double w746 = w352 * w699;
    const double w747 = c[54][l] * w745;
    const double w748 = c[160][l] * w746;
    const double w749 = w747 + w748;
    const double w750 = w340 * w749;
    const double w751 = w335 * w750;
    const double w752 = w751 * w362;
    const double w753 = c[63][l] * w751;
    const double w754 = c[162][l] * w752;
    const double w755 = w753 + w754;
    const double w756 = (-100000.0) * w739;
    const double w757 = 100000.0 * w739;
    const double w758 = w65 * w698;
    const double w759 = w34 * w737;
    const double w760 = c[53][l] * w758;
    const double w761 = w760 + w759;
    const double w762 = w37 * w761;
    const double w763 = w84 * w699;
    const double w764 = c[20][l] * w762;
    const double w765 = c[154][l] * w763;
    const double w766 = w764 + w765;
    const double w767 = w[10][l] * w766;
    const double w768 = c[52][l] * w695;
    const double w769 = w693 + w768;
    const double w770 = w399 * w769;
    const double w771 = w394 * w770;
    const double w772 = w389 * w771;
    const double w773 = u4 * w771;
    const double w774 = w773 * w97;
    const double w775 = c[166][l] * w772;
    const double w776 = c[167][l] * w774;
    const double w777 = w775 + w776;
    const double w778 = w388 * w777;
    const double w779 = w411 * w[127][l];
    const double w780 = w778 + w779;
    const double w781 = w383 * w780;
    const double w782 = w415 * w777;
    const double w783 = -w782;
    const double w784 = w781 + w783;
    const double w785 = (-100000.0) * w777;
    const double w786 = (-100000.0) * w784;
    const double w787 = w785 + w786;
    const double w788 = w423 * w787;
    const double w789 = w110 * w788;
    const double w790 = w109 * w788;
    const double w791 = w109 * w790;
    const double w792 = 2.0 * w791;
    const double w793 = w789 + w792;
    const double w794 = w113 * w793;
    const double w795 = w111 * w788;
    const double w796 = 100000.0 * w784;
    const double w797 = w785 + w796;
    const double w798 = w439 * w797;
    const double w799 = w118 * w798;
    const double w800 = w117 * w798;
    const double w801 = w117 * w800;
    const double w802 = 2.0 * w801;
    const double w803 = w799 + w802;
    const double w804 = w121 * w803;
    const double w805 = w119 * w798;
    const double w806 = 1e-05 * w794;
    const double w807 = w784 + w806;
    const double w808 = (-5e-06) * w795;
    const double w809 = w807 + w808;
    const double w810 = (-1e-05) * w804;
    const double w811 = w809 + w810;
    const double w812 = 5e-06 * w805;
    const double w813 = w811 + w812;
    const double w814 = w90 * w813;
    const double w815 = w126 * w770;
    const double w816 = c[66][l] * w815;
    const double w817 = w814 + w816;
    const double w818 = w93 * w817;
    const double w819 = w127 * w771;
    const double w820 = c[8][l] * w818;
    const double w821 = c[168][l] * w819;
    const double w822 = w820 + w821;
    const double w823 = w126 * w813;
    const double w824 = w823 * w468;
    const double w825 = w136 * w[129][l];
    const double w826 = w485 * w770;
    const double w827 = w[28][l] * w826;
    const double w828 = c[170][l] * w827;
    const double w829 = w825 + w828;
    const double w830 = w829 * w97;
    const double w831 = w491 * w771;
    const double w832 = c[68][l] * w830;
    const double w833 = c[166][l] * w831;
    const double w834 = w832 + w833;
    const double w835 = w479 * w834;
    const double w836 = w474 * w835;
    const double w837 = w836 * w501;
    const double w838 = c[78][l] * w836;
    const double w839 = c[172][l] * w837;
    const double w840 = w838 + w839;
    const double w841 = (-100000.0) * w824;
    const double w842 = 100000.0 * w824;
    const double w843 = c[70][l] * w822;
    const double w844 = w519 * w771;
    const double w845 = u5 * w771;
    const double w846 = w845 * w97;
    const double w847 = c[176][l] * w844;
    const double w848 = c[177][l] * w846;
    const double w849 = w847 + w848;
    const double w850 = w518 * w849;
    const double w851 = w527 * w[137][l];
    const double w852 = w850 + w851;
    const double w853 = w513 * w852;
    const double w854 = w531 * w849;
    const double w855 = -w854;
    const double w856 = w853 + w855;
    const double w857 = (-100000.0) * w849;
    const double w858 = (-100000.0) * w856;
    const double w859 = w857 + w858;
    const double w860 = w539 * w859;
    const double w861 = w163 * w860;
    const double w862 = w162 * w860;
    const double w863 = w162 * w862;
    const double w864 = 2.0 * w863;
    const double w865 = w861 + w864;
    const double w866 = w166 * w865;
    const double w867 = w164 * w860;
    const double w868 = 100000.0 * w856;
    const double w869 = w857 + w868;
    const double w870 = w555 * w869;
    const double w871 = w171 * w870;
    const double w872 = w170 * w870;
    const double w873 = w170 * w872;
    const double w874 = 2.0 * w873;
    const double w875 = w871 + w874;
    const double w876 = w174 * w875;
    const double w877 = w172 * w870;
    const double w878 = 1e-05 * w866;
    const double w879 = w856 + w878;
    const double w880 = (-5e-06) * w867;
    const double w881 = w879 + w880;
    const double w882 = (-1e-05) * w876;
    const double w883 = w881 + w882;
    const double w884 = 5e-06 * w877;
    const double w885 = w883 + w884;
    const double w886 = w90 * w885;
    const double w887 = w179 * w770;
    const double w888 = c[66][l] * w887;
    const double w889 = w886 + w888;
    const double w890 = w93 * w889;
    const double w891 = w180 * w771;
    const double w892 = c[13][l] * w890;
    const double w893 = c[178][l] * w891;
    const double w894 = w892 + w893;
    const double w895 = w179 * w885;
    const double w896 = w895 * w584;
    const double w897 = w136 * w[139][l];
    const double w898 = w[40][l] * w826;
    const double w899 = c[170][l] * w898;
    const double w900 = w897 + w899;
    const double w901 = w900 * w97;
    const double w902 = w601 * w771;
    const double w903 = c[83][l] * w901;
    const double w904 = c[176][l] * w902;
    const double w905 = w903 + w904;
    const double w906 = w595 * w905;
    const double w907 = w590 * w906;
    const double w908 = w907 * w611;
    const double w909 = c[78][l] * w907;
    const double w910 = c[172][l] * w908;
    const double w911 = w909 + w910;
    const double w912 = (-100000.0) * w896;
    const double w913 = 100000.0 * w896;
    const double w914 = c[70][l] * w894;
    const double w915 = c[94][l] * w767;
    const double w916 = w[146][l] + w915;
    const double w917 = w630 * w[148][l];
    const double w918 = w625 * w917;
    const double w919 = w637 * w918;
    const double w920 = w209 * w919;
    const double w921 = w208 * w919;
    const double w922 = w207 * w919;
    const double w923 = w207 * w922;
    const double w924 = c[181][l] * w921;
    const double w925 = c[183][l] * w923;
    const double w926 = w924 + w925;
    const double w927 = w211 * w926;
    const double w928 = w651 * w918;
    const double w929 = w216 * w928;
    const double w930 = w215 * w928;
    const double w931 = w215 * w930;
    const double w932 = c[181][l] * w929;
    const double w933 = c[183][l] * w931;
    const double w934 = w932 + w933;
    const double w935 = w219 * w934;
    const double w936 = w217 * w928;
    const double w937 = c[31][l] * w918;
    const double w938 = c[182][l] * w920;
    const double w939 = w937 + w938;
    const double w940 = (-0.2) * w927;
    const double w941 = w939 + w940;
    const double w942 = (-0.2) * w935;
    const double w943 = w941 + w942;
    const double w944 = c[184][l] * w936;
    const double w945 = w943 + w944;
    const double w946 = w[53][l] * w945;
    const double w947 = w224 * w[149][l];
    const double w948 = c[103][l] * w946;
    const double w949 = c[103][l] * w947;
    const double w950 = w948 + w949;
    const double w951 = w228 * w[110][l];
    const double w952 = c[69][l] * w822;
    const double w953 = w[11][l] * w766;
    const double w954 = c[186][l] * w894;
    const double w955 = w[152][l] + w954;
    const double w956 = c[94][l] * w950;
    const double w957 = w955 + w956;
    const double w958 = c[111][l] * w951;
    const double w959 = w957 + w958;
    const double w960 = w240 * w[110][l];
    const double w961 = c[193][l] * w894;
    const double w962 = w[154][l] + w961;
    const double w963 = c[192][l] * w950;
    const double w964 = w962 + w963;
    const double w965 = c[118][l] * w960;
    const double w966 = w964 + w965;
    w[8][l] = w34;
    w[9][l] = w37;
    w[14][l] = w70;
    w[16][l] = w79;
    w[17][l] = w80;
    w[21][l] = w81;
    w[22][l] = w83;
    w[23][l] = w90;
    w[24][l] = w93;
    w[27][l] = w133;
    w[29][l] = w142;
    w[30][l] = w143;
    w[34][l] = w144;
    w[35][l] = w146;
    w[36][l] = w147;
    w[39][l] = w186;
    w[41][l] = w192;
    w[42][l] = w193;
    w[46][l] = w194;
    w[47][l] = w196;
    w[48][l] = w197;
    w[50][l] = w199;
    w[55][l] = w230;
    w[56][l] = w232;
    w[58][l] = w238;
    w[61][l] = w247;
    w[66][l] = w260;
    w[67][l] = w272;
    w[70][l] = w330;
    w[72][l] = w366;
    w[75][l] = w367;
    w[76][l] = w368;
    w[77][l] = w402;
    w[78][l] = w403;
    w[81][l] = w469;
    w[83][l] = w505;
    w[86][l] = w506;
    w[87][l] = w507;
    w[88][l] = w508;
    w[91][l] = w585;
    w[93][l] = w615;
    w[96][l] = w616;
    w[97][l] = w617;
    w[98][l] = w618;
    w[100][l] = w620;
    w[103][l] = w676;
    w[104][l] = w677;
    w[106][l] = w683;
    w[108][l] = w690;
    w[113][l] = w698;
    w[114][l] = w699;
    w[117][l] = w739;
    w[119][l] = w755;
    w[122][l] = w756;
    w[123][l] = w757;
    w[124][l] = w770;
    w[125][l] = w771;
    w[128][l] = w824;
    w[130][l] = w840;
    w[133][l] = w841;
    w[134][l] = w842;
    w[135][l] = w843;
    w[138][l] = w896;
    w[140][l] = w911;
    w[143][l] = w912;
    w[144][l] = w913;
    w[145][l] = w914;
    w[147][l] = w916;
    w[150][l] = w952;
    w[151][l] = w953;
    w[153][l] = w959;
    w[155][l] = w966;
}

INLINE void turn2(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[16][l]);
    const double w1 = c[62][l] * w0;
    const double w2 = w[17][l] + w1;
    const double w3 = c[21][l] * w2;
    const double w4 = lane_atan(w[29][l]);
    const double w5 = c[79][l] * w4;
    const double w6 = w[30][l] + w5;
    const double w7 = c[9][l] * w6;
    const double w8 = lane_atan(w[41][l]);
    const double w9 = c[79][l] * w8;
    const double w10 = w[42][l] + w9;
    const double w11 = c[9][l] * w10;
    const double w12 = w2 * w2;
    const double w13 = c[161][l] * w12;
    const double w14 = w13 + 1.0;
    const double w15 = 1.0 / w14;
    const double w16 = w[72][l] * w15;
    const double w17 = w6 * w6;
    const double w18 = c[171][l] * w17;
    const double w19 = w18 + 1.0;
    const double w20 = 1.0 / w19;
    const double w21 = w[83][l] * w20;
    const double w22 = w10 * w10;
    const double w23 = c[171][l] * w22;
    const double w24 = w23 + 1.0;
    const double w25 = 1.0 / w24;
    const double w26 = w[93][l] * w25;
    const double w27 = w[119][l] * w15;
    const double w28 = w[130][l] * w20;
    const double w29 = w[140][l] * w25;
    w[18][l] = w3;
    w[31][l] = w7;
    w[43][l] = w11;
    w[73][l] = w16;
    w[84][l] = w21;
    w[94][l] = w26;
    w[120][l] = w27;
    w[131][l] = w28;
    w[141][l] = w29;
}

INLINE void turn3(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[18][l]);
    const double w1 = c[22][l] * w0;
    const double w2 = lane_atan(w[31][l]);
    const double w3 = c[10][l] * w2;
    const double w4 = lane_atan(w[43][l]);
    const double w5 = c[10][l] * w4;
    w[19][l] = w1;
    w[32][l] = w3;
    w[44][l] = w5;
}

INLINE void turn4(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_sin(w[19][l]);
    const double w1 = w0 * w[20][l];
    const double w2 = w1 * w[12][l];
    const double w3 = c[23][l] * w2;
    const double w4 = lane_min(w[14][l], w3);
    const double w5 = lane_max(w[21][l], w4);
    const double w6 = (-100000.0) * w5;
    const double w7 = w[22][l] + w6;
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 100000.0 * w5;
    const double w15 = w[22][l] + w14;
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 1e-05 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-1e-05) * w21;
    const double w25 = w23 + w24;
    const double w26 = w[8][l] * w25;
    const double w27 = w26 * w[9][l];
    const double w28 = w27 * w[11][l];
    const double w29 = lane_sin(w[32][l]);
    const double w30 = w29 * w[33][l];
    const double w31 = w30 * w[25][l];
    const double w32 = c[11][l] * w31;
    const double w33 = lane_min(w[27][l], w32);
    const double w34 = lane_max(w[34][l], w33);
    const double w35 = (-100000.0) * w34;
    const double w36 = w[35][l] + w35;
    const double w37 = lane_max(0.0, w36);
    const double w38 = w37 * w37;
    const double w39 = w37 * w38;
    const double w40 = (-0.5) * w37;
    const double w41 = w40 + 1.0;
    const double w42 = w39 * w41;
    const double w43 = 100000.0 * w34;
    const double w44 = w[35][l] + w43;
    const double w45 = lane_max(0.0, w44);
    const double w46 = w45 * w45;
    const double w47 = w45 * w46;
    const double w48 = (-0.5) * w45;
    const double w49 = w48 + 1.0;
    const double w50 = w47 * w49;
    const double w51 = 1e-05 * w42;
    const double w52 = w34 + w51;
    const double w53 = (-1e-05) * w50;
    const double w54 = w52 + w53;
    const double w55 = w[23][l] * w54;
    const double w56 = w55 * w[24][l];
    const double w57 = c[81][l] * w56;
    const double w58 = w[36][l] + w57;
    const double w59 = lane_sin(w[44][l]);
    const double w60 = w59 * w[45][l];
    const double w61 = w60 * w[37][l];
    const double w62 = c[11][l] * w61;
    const double w63 = lane_min(w[39][l], w62);
    const double w64 = lane_max(w[46][l], w63);
    const double w65 = (-100000.0) * w64;
    const double w66 = w[47][l] + w65;
    const double w67 = lane_max(0.0, w66);
    const double w68 = w67 * w67;
    const double w69 = w67 * w68;
    const double w70 = (-0.5) * w67;
    const double w71 = w70 + 1.0;
    const double w72 = w69 * w71;
    const double w73 = 100000.0 * w64;
    const double w74 = w[47][l] + w73;
    const double w75 = lane_max(0.0, w74);
    const double w76 = w75 * w75;
    const double w77 = w75 * w76;
    const double w78 = (-0.5) * w75;
    const double w79 = w78 + 1.0;
    const double w80 = w77 * w79;
    const double w81 = 1e-05 * w72;
    const double w82 = w64 + w81;
    const double w83 = (-1e-05) * w80;
    const double w84 = w82 + w83;
    const double w85 = w[23][l] * w84;
    const double w86 = w85 * w[24][l];
    const double w87 = c[88][l] * w86;
    const double w88 = w[48][l] + w87;
    const double w89 = c[92][l] * w28;
    const double w90 = w[50][l] + w89;
    const double w91 = c[94][l] * w58;
    const double w92 = w90 + w91;
    const double w93 = c[94][l] * w88;
    const double w94 = w92 + w93;
    const double w95 = c[75][l] * w56;
    const double w96 = w[55][l] + w95;
    const double w97 = w27 * w[10][l];
    const double w98 = c[64][l] * w97;
    const double w99 = w[56][l] + w98;
    const double w100 = c[112][l] * w86;
    const double w101 = w[58][l] + w100;
    const double w102 = c[94][l] * w96;
    const double w103 = w101 + w102;
    const double w104 = c[94][l] * w99;
    const double w105 = w103 + w104;
    const double w106 = c[121][l] * w58;
    const double w107 = w[61][l] + w106;
    const double w108 = c[126][l] * w86;
    const double w109 = w107 + w108;
    const double w110 = c[122][l] * w88;
    const double w111 = w109 + w110;
    const double w112 = c[123][l] * w96;
    const double w113 = w111 + w112;
    const double w114 = c[124][l] * w99;
    const double w115 = w113 + w114;
    const double w116 = w25 * w[66][l];
    const double w117 = w4 <= w[21][l] ? 1.0 : 0.0;
    const double w118 = w[21][l] <= w4 ? 1.0 : 0.0;
    const double w119 = w117 + w118;
    const double w120 = 1.0 / w119;
    const double w121 = w117 * w120;
    const double w122 = w121 * w[70][l];
    const double w123 = w118 * w120;
    const double w124 = w3 <= w[14][l] ? 1.0 : 0.0;
    const double w125 = w[14][l] <= w3 ? 1.0 : 0.0;
    const double w126 = w124 + w125;
    const double w127 = 1.0 / w126;
    const double w128 = w124 * w127;
    const double w129 = lane_cos(w[19][l]);
    const double w130 = w129 * w[73][l];
    const double w131 = w[20][l] * w130;
    const double w132 = w0 * w[74][l];
    const double w133 = c[163][l] * w131;
    const double w134 = c[164][l] * w132;
    const double w135 = w133 + w134;
    const double w136 = w135 * w[12][l];
    const double w137 = w2 * w[12][l];
    const double w138 = w137 * w[68][l];
    const double w139 = c[165][l] * w138;
    const double w140 = w136 + w139;
    const double w141 = w128 * w140;
    const double w142 = w125 * w127;
    const double w143 = w142 * w[70][l];
    const double w144 = -w143;
    const double w145 = w141 + w144;
    const double w146 = w123 * w145;
    const double w147 = w122 + w146;
    const double w148 = 0.0 <= w7 ? 1.0 : 0.0;
    const double w149 = w7 <= 0.0 ? 1.0 : 0.0;
    const double w150 = w148 + w149;
    const double w151 = 1.0 / w150;
    const double w152 = w148 * w151;
    const double w153 = 100000.0 * w147;
    const double w154 = w[75][l] + w153;
    const double w155 = w152 * w154;
    const double w156 = w10 * w155;
    const double w157 = w9 * w155;
    const double w158 = w8 * w155;
    const double w159 = w8 * w158;
    const double w160 = 2.0 * w159;
    const double w161 = w157 + w160;
    const double w162 = w12 * w161;
    const double w163 = 0.0 <= w15 ? 1.0 : 0.0;
    const double w164 = w15 <= 0.0 ? 1.0 : 0.0;
    const double w165 = w163 + w164;
    const double w166 = 1.0 / w165;
    const double w167 = w163 * w166;
    const double w168 = w[76][l] + w153;
    const double w169 = w167 * w168;
    const double w170 = w17 * w169;
    const double w171 = w16 * w169;
    const double w172 = w16 * w171;
    const double w173 = 2.0 * w172;
    const double w174 = w170 + w173;
    const double w175 = w20 * w174;
    const double w176 = w18 * w169;
    const double w177 = 5e-06 * w156;
    const double w178 = w147 + w177;
    const double w179 = (-1e-05) * w162;
    const double w180 = w178 + w179;
    const double w181 = (-1e-05) * w175;
    const double w182 = w180 + w181;
    const double w183 = 5e-06 * w176;
    const double w184 = w182 + w183;
    const double w185 = w[8][l] * w184;
    const double w186 = c[53][l] * w116;
    const double w187 = w186 + w185;
    const double w188 = w[9][l] * w187;
    const double w189 = w26 * w[67][l];
    const double w190 = c[20][l] * w188;
    const double w191 = c[154][l] * w189;
    const double w192 = w190 + w191;
    const double w193 = w[11][l] * w192;
    const double w194 = w33 <= w[34][l] ? 1.0 : 0.0;
    const double w195 = w[34][l] <= w33 ? 1.0 : 0.0;
    const double w196 = w194 + w195;
    const double w197 = 1.0 / w196;
    const double w198 = w194 * w197;
    const double w199 = w198 * w[81][l];
    const double w200 = w195 * w197;
    const double w201 = w32 <= w[27][l] ? 1.0 : 0.0;
    const double w202 = w[27][l] <= w32 ? 1.0 : 0.0;
    const double w203 = w201 + w202;
    const double w204 = 1.0 / w203;
    const double w205 = w201 * w204;
    const double w206 = lane_cos(w[32][l]);
    const double w207 = w206 * w[84][l];
    const double w208 = w[33][l] * w207;
    const double w209 = w29 * w[85][l];
    const double w210 = c[173][l] * w208;
    const double w211 = c[174][l] * w209;
    const double w212 = w210 + w211;
    const double w213 = w212 * w[25][l];
    const double w214 = w31 * w[25][l];
    const double w215 = w214 * w[79][l];
    const double w216 = c[175][l] * w215;
    const double w217 = w213 + w216;
    const double w218 = w205 * w217;
    const double w219 = w202 * w204;
    const double w220 = w219 * w[81][l];
    const double w221 = -w220;
    const double w222 = w218 + w221;
    const double w223 = w200 * w222;
    const double w224 = w199 + w223;
    const double w225 = 0.0 <= w36 ? 1.0 : 0.0;
    const double w226 = w36 <= 0.0 ? 1.0 : 0.0;
    const double w227 = w225 + w226;
    const double w228 = 1.0 / w227;
    const double w229 = w225 * w228;
    const double w230 = 100000.0 * w224;
    const double w231 = w[86][l] + w230;
    const double w232 = w229 * w231;
    const double w233 = w39 * w232;
    const double w234 = w38 * w232;
    const double w235 = w37 * w232;
    const double w236 = w37 * w235;
    const double w237 = 2.0 * w236;
    const double w238 = w234 + w237;
    const double w239 = w41 * w238;
    const double w240 = 0.0 <= w44 ? 1.0 : 0.0;
    const double w241 = w44 <= 0.0 ? 1.0 : 0.0;
    const double w242 = w240 + w241;
    const double w243 = 1.0 / w242;
    const double w244 = w240 * w243;
    const double w245 = w[87][l] + w230;
    const double w246 = w244 * w245;
    const double w247 = w46 * w246;
    const double w248 = w45 * w246;
    const double w249 = w45 * w248;
    const double w250 = 2.0 * w249;
    const double w251 = w247 + w250;
    const double w252 = w49 * w251;
    const double w253 = w47 * w246;
    const double w254 = 5e-06 * w233;
    const double w255 = w224 + w254;
    const double w256 = (-1e-05) * w239;
    const double w257 = w255 + w256;
    const double w258 = (-1e-05) * w252;
    const double w259 = w257 + w258;
    const double w260 = 5e-06 * w253;
    const double w261 = w259 + w260;
    const double w262 = w[23][l] * w261;
    const double w263 = w54 * w[77][l];
    const double w264 = c[66][l] * w263;
    const double w265 = w262 + w264;
    const double w266 = w[24][l] * w265;
    const double w267 = w55 * w[78][l];
    const double w268 = c[8][l] * w266;
    const double w269 = c[168][l] * w267;
    const double w270 = w268 + w269;
    const double w271 = c[72][l] * w270;
    const double w272 = w[88][l] + w271;
    const double w273 = w63 <= w[46][l] ? 1.0 : 0.0;
    const double w274 = w[46][l] <= w63 ? 1.0 : 0.0;
    const double w275 = w273 + w274;
    const double w276 = 1.0 / w275;
    const double w277 = w273 * w276;
    const double w278 = w277 * w[91][l];
    const double w279 = w274 * w276;
    const double w280 = w62 <= w[39][l] ? 1.0 : 0.0;
    const double w281 = w[39][l] <= w62 ? 1.0 : 0.0;
    const double w282 = w280 + w281;
    const double w283 = 1.0 / w282;
    const double w284 = w280 * w283;
    const double w285 = lane_cos(w[44][l]);
    const double w286 = w285 * w[94][l];
    const double w287 = w[45][l] * w286;
    const double w288 = w59 * w[95][l];
    const double w289 = c[173][l] * w287;
    const double w290 = c[174][l] * w288;
    const double w291 = w289 + w290;
    const double w292 = w291 * w[37][l];
    const double w293 = w61 * w[37][l];
    const double w294 = w293 * w[89][l];
    const double w295 = c[175][l] * w294;
    const double w296 = w292 + w295;
    const double w297 = w284 * w296;
    const double w298 = w281 * w283;
    const double w299 = w298 * w[91][l];
    const double w300 = -w299;
    const double w301 = w297 + w300;
    const double w302 = w279 * w301;
    const double w303 = w278 + w302;
    const double w304 = 0.0 <= w66 ? 1.0 : 0.0;
    const double w305 = w66 <= 0.0 ? 1.0 : 0.0;
    const double w306 = w304 + w305;
    const double w307 = 1.0 / w306;
    const double w308 = w304 * w307;
    const double w309 = 100000.0 * w303;
    const double w310 = w[96][l] + w309;
    const double w311 = w308 * w310;
    const double w312 = w69 * w311;
    const double w313 = w68 * w311;
    const double w314 = w67 * w311;
    const double w315 = w67 * w314;
    const double w316 = 2.0 * w315;
    const double w317 = w313 + w316;
    const double w318 = w71 * w317;
    const double w319 = 0.0 <= w74 ? 1.0 : 0.0;
    const double w320 = w74 <= 0.0 ? 1.0 : 0.0;
    const double w321 = w319 + w320;
    const double w322 = 1.0 / w321;
    const double w323 = w319 * w322;
    const double w324 = w[97][l] + w309;
    const double w325 = w323 * w324;
    const double w326 = w76 * w325;
    const double w327 = w75 * w325;
    const double w328 = w75 * w327;
    const double w329 = 2.0 * w328;
    const double w330 = w326 + w329;
    const double w331 = w79 * w330;
    const double w332 = w77 * w325;
    const double w333 = 5e-06 * w312;
    const double w334 = w303 + w333;
    const double w335 = (-1e-05) * w318;
    const double w336 = w334 + w335;
    const double w337 = (-1e-05) * w331;
    const double w338 = w336 + w337;
    const double w339 = 5e-06 * w332;
    const double w340 = w338 + w339;
    const double w341 = w[23][l] * w340;
    const double w342 = w84 * w[77][l];
    const double w343 = c[66][l] * w342;
    const double w344 = w341 + w343;
    const double w345 = w[24][l] * w344;
    const double w346 = w85 * w[78][l];
    const double w347 = c[13][l] * w345;
    const double w348 = c[178][l] * w346;
    const double w349 = w347 + w348;
    const double w350 = c[69][l] * w349;
    const double w351 = w[98][l] + w350;
    const double w352 = c[179][l] * w193;
    const double w353 = w[100][l] + w352;
    const double w354 = c[94][l] * w272;
    const double w355 = w353 + w354;
    const double w356 = c[94][l] * w351;
    const double w357 = w355 + w356;
    const double w358 = c[70][l] * w270;
    const double w359 = w[103][l] + w358;
    const double w360 = w[10][l] * w192;
    const double w361 = c[56][l] * w360;
    const double w362 = w[104][l] + w361;
    const double w363 = c[189][l] * w349;
    const double w364 = w[106][l] + w363;
    const double w365 = c[94][l] * w359;
    const double w366 = w364 + w365;
    const double w367 = c[94][l] * w362;
    const double w368 = w366 + w367;
    const double w369 = c[121][l] * w272;
    const double w370 = w[108][l] + w369;
    const double w371 = c[194][l] * w349;
    const double w372 = w370 + w371;
    const double w373 = c[122][l] * w351;
    const double w374 = w372 + w373;
    const double w375 = c[123][l] * w359;
    const double w376 = w374 + w375;
    const double w377 = c[124][l] * w362;
    const double w378 = w376 + w377;
    const double w379 = w25 * w[113][l];
    const double w380 = w121 * w[117][l];
    const double w381 = w129 * w[120][l];
    const double w382 = w[20][l] * w381;
    const double w383 = w0 * w[121][l];
    const double w384 = c[163][l] * w382;
    const double w385 = c[164][l] * w383;
    const double w386 = w384 + w385;
    const double w387 = w386 * w[12][l];
    const double w388 = w137 * w[115][l];
    const double w389 = c[165][l] * w388;
    const double w390 = w387 + w389;
    const double w391 = w128 * w390;
    const double w392 = w142 * w[117][l];
    const double w393 = -w392;
    const double w394 = w391 + w393;
    const double w395 = w123 * w394;
    const double w396 = w380 + w395;
    const double w397 = 100000.0 * w396;
    const double w398 = w[122][l] + w397;
    const double w399 = w152 * w398;
    const double w400 = w10 * w399;
    const double w401 = w9 * w399;
    const double w402 = w8 * w399;
    const double w403 = w8 * w402;
    const double w404 = 2.0 * w403;
    const double w405 = w401 + w404;
    const double w406 = w12 * w405;
    const double w407 = w[123][l] + w397;
    const double w408 = w167 * w407;
    const double w409 = w17 * w408;
    const double w410 = w16 * w408;
    const double w411 = w16 * w410;
    const double w412 = 2.0 * w411;
    const double w413 = w409 + w412;
    const double w414 = w20 * w413;
    const double w415 = w18 * w408;
    const double w416 = 5e-06 * w400;
    const double w417 = w396 + w416;
    const double w418 = (-1e-05) * w406;
    const double w419 = w417 + w418;
    const double w420 = (-1e-05) * w414;
    const double w421 = w419 + w420;
    const double w422 = 5e-06 * w415;
    const double w423 = w421 + w422;
    const double w424 = w[8][l] * w423;
    const double w425 = c[53][l] * w379;
    const double w426 = w425 + w424;
    const double w427 = w[9][l] * w426;
    const double w428 = w26 * w[114][l];
    const double w429 = c[20][l] * w427;
    const double w430 = c[154][l] * w428;
    const double w431 = w429 + w430;
    const double w432 = w[11][l] * w431;
    const double w433 = w198 * w[128][l];
    const double w434 = w206 * w[131][l];
    const double w435 = w[33][l] * w434;
    const double w436 = w29 * w[132][l];
    const double w437 = c[173][l] * w435;
    const double w438 = c[174][l] * w436;
    const double w439 = w437 + w438;
    const double w440 = w439 * w[25][l];
    const double w441 = w214 * w[126][l];
    const double w442 = c[175][l] * w441;
    const double w443 = w440 + w442;
    const double w444 = w205 * w443;
    const double w445 = w219 * w[128][l];
    const double w446 = -w445;
    const double w447 = w444 + w446;
    const double w448 = w200 * w447;
    const double w449 = w433 + w448;
    const double w450 = 100000.0 * w449;
    const double w451 = w[133][l] + w450;
    const double w452 = w229 * w451;
    const double w453 = w39 * w452;
    const double w454 = w38 * w452;
    const double w455 = w37 * w452;
    const double w456 = w37 * w455;
    const double w457 = 2.0 * w456;
    const double w458 = w454 + w457;
    const double w459 = w41 * w458;
    const double w460 = w[134][l] + w450;
    const double w461 = w244 * w460;
    const double w462 = w46 * w461;
    const double w463 = w45 * w461;
    const double w464 = w45 * w463;
    const double w465 = 2.0 * w464;
    const double w466 = w462 + w465;
    const double w467 = w49 * w466;
    const double w468 = w47 * w461;
    const double w469 = 5e-06 * w453;
    const double w470 = w449 + w469;
    const double w471 = (-1e-05) * w459;
    const double w472 = w470 + w471;
    const double w473 = (-1e-05) * w467;
    const double w474 = w472 + w473;
    const double w475 = 5e-06 * w468;
    const double w476 = w474 + w475;
    const double w477 = w[23][l] * w476;
    const double w478 = w54 * w[124][l];
    const double w479 = c[66][l] * w478;
    const double w480 = w477 + w479;
    const double w481 = w[24][l] * w480;
    const double w482 = w55 * w[125][l];
    const double w483 = c[8][l] * w481;
    const double w484 = c[168][l] * w482;
    const double w485 = w483 + w484;
    const double w486 = c[72][l] * w485;
    const double w487 = w[135][l] + w486;
    const double w488 = w277 * w[138][l];
    const double w489 = w285 * w[141][l];
    const double w490 = w[45][l] * w489;
    const double w491 = w59 * w[142][l];
    const double w492 = c[173][l] * w490;
    const double w493 = c[174][l] * w491;
    const double w494 = w492 + w493;
    const double w495 = w494 * w[37][l];
    const double w496 = w293 * w[136][l];
    const double w497 = c[175][l] * w496;
    const double w498 = w495 + w497;
    const double w499 = w284 * w498;
    const double w500 = w298 * w[138][l];
    const double w501 = -w500;
    const double w502 = w499 + w501;
    const double w503 = w279 * w502;
    const double w504 = w488 + w503;
    const double w505 = 100000.0 * w504;
    const double w506 = w[143][l] + w505;
    const double w507 = w308 * w506;
    const double w508 = w69 * w507;
    const double w509 = w68 * w507;
    const double w510 = w67 * w507;
    const double w511 = w67 * w510;
    const double w512 = 2.0 * w511;
    const double w513 = w509 + w512;
    const double w514 = w71 * w513;
    const double w515 = w[144][l] + w505;
    const double w516 = w323 * w515;
    const double w517 = w76 * w516;
    const double w518 = w75 * w516;
    const double w519 = w75 * w518;
    const double w520 = 2.0 * w519;
    const double w521 = w517 + w520;
    const double w522 = w79 * w521;
    const double w523 = w77 * w516;
    const double w524 = 5e-06 * w508;
    const double w525 = w504 + w524;
    const double w526 = (-1e-05) * w514;
    const double w527 = w525 + w526;
    const double w528 = (-1e-05) * w522;
    const double w529 = w527 + w528;
    const double w530 = 5e-06 * w523;
    const double w531 = w529 + w530;
    const double w532 = w[23][l] * w531;
    const double w533 = w84 * w[124][l];
    const double w534 = c[66][l] * w533;
    const double w535 = w532 + w534;
    const double w536 = w[24][l] * w535;
    const double w537 = w85 * w[125][l];
    const double w538 = c[13][l] * w536;
    const double w539 = c[178][l] * w537;
    const double w540 = w538 + w539;
    const double w541 = c[69][l] * w540;
    const double w542 = w[145][l] + w541;
    const double w543 = c[179][l] * w432;
    const double w544 = w[147][l] + w543;
    const double w545 = c[94][l] * w487;
    const double w546 = w544 + w545;
    const double w547 = c[94][l] * w542;
    const double w548 = w546 + w547;
    const double w549 = c[70][l] * w485;
    const double w550 = w[150][l] + w549;
    const double w551 = w[10][l] * w431;
    const double w552 = c[56][l] * w551;
    const double w553 = w[151][l] + w552;
    const double w554 = c[189][l] * w540;
    const double w555 = w[153][l] + w554;
    const double w556 = c[94][l] * w550;
    const double w557 = w555 + w556;
    const double w558 = c[94][l] * w553;
    const double w559 = w557 + w558;
    const double w560 = c[121][l] * w487;
    const double w561 = w[155][l] + w560;
    const double w562 = c[194][l] * w540;
    const double w563 = w561 + w562;
    const double w564 = c[122][l] * w542;
    const double w565 = w563 + w564;
    const double w566 = c[123][l] * w550;
    const double w567 = w565 + w566;
    const double w568 = c[124][l] * w553;
    const double w569 = w567 + w568;
    WRITE(f, S0, w94);
    WRITE(f, S1, w105);
    WRITE(f, S2, w115);
    WRITE(r, S0, w357);
    WRITE(r, S1, w368);
    WRITE(r, S2, w378);
    WRITE_MOVING(g, S0, w548);
    WRITE_MOVING(g, S1, w559);
    WRITE_MOVING(g, S2, w569);
}

APART void turns(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g)
{
    lanes w[156];
    LANE_LOOP turn0(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn1(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn2(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn3(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn4(c, u, x, e, m, f, r, g, w, l);
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
    const double w8 = w7 + 0.0001;
    const double w9 = sqrt(w8);
    const double w10 = w6 * w9;
    const double w11 = c[37][l] * u2;
    const double w12 = w11 + w10;
    const double w13 = w12 * w12;
    const double w14 = w13 + 1e-08;
    const double w15 = sqrt(w14);
    const double w16 = c[36][l] * u2;
    const double w17 = 0.5 * w10;
    const double w18 = w16 + w17;
    const double w19 = 0.5 * w15;
    const double w20 = w18 + w19;
    const double w21 = sqrt(w20);
    const double w22 = lane_atan2(0.0, w21);
    const double w23 = c[1][l] * u3;
    const double w24 = w23 + c[38][l];
    const double w25 = c[35][l] * w22;
    const double w26 = w24 + w25;
    const double w27 = c[2][l] * w26;
    const double w28 = lane_min(c[33][l], w27);
    const double w29 = lane_max(c[34][l], w28);
    const double w30 = (-5.0) * w29;
    const double w31 = w30 + c[39][l];
    const double w32 = lane_max(0.0, w31);
    const double w33 = w32 * w32;
    const double w34 = w32 * w33;
    const double w35 = (-0.5) * w32;
    const double w36 = w35 + 1.0;
    const double w37 = w34 * w36;
    const double w38 = 5.0 * w29;
    const double w39 = w38 + c[39][l];
    const double w40 = lane_max(0.0, w39);
    const double w41 = w40 * w40;
    const double w42 = w40 * w41;
    const double w43 = (-0.5) * w40;
    const double w44 = w43 + 1.0;
    const double w45 = w42 * w44;
    const double w46 = 0.2 * w37;
    const double w47 = w29 + w46;
    const double w48 = (-0.2) * w45;
    const double w49 = w47 + w48;
    const double w50 = w49 * w20;
    const double w51 = w7 + 1e-08;
    const double w52 = u1 * w0;
    const double w53 = u0 * w2;
    const double w54 = -w53;
    const double w55 = w52 + w54;
    const double w56 = -w55;
    const double w57 = x1 + w56;
    const double w58 = w57 * w57;
    const double w59 = w51 + w58;
    const double w60 = w59 * w6;
    const double w61 = sqrt(w51);
    const double w62 = 1.0 / w61;
    const double w63 = w60 * w62;
    const double w64 = c[45][l] * w63;
    const double w65 = w64 + c[32][l];
    const double w66 = c[41][l] * w50;
    const double w67 = w65 + w66;
    const double w68 = c[3][l] * u3;
    const double w69 = w68 + c[49][l];
    const double w70 = w59 * w69;
    const double w71 = c[50][l] * u2;
    const double w72 = c[48][l] * w70;
    const double w73 = w71 + w72;
    const double w74 = c[47][l] * w50;
    const double w75 = w73 + w74;
    const double w76 = c[46][l] * w67;
    const double w77 = w76 + w75;
    const double w78 = c[53][l] * w77;
    const double w79 = lane_max(0.0, w78);
    const double w80 = c[19][l] * w79;
    const double w81 = w80 + c[18][l];
    const double w82 = lane_max(0.001, w81);
    const double w83 = 1.0 / w82;
    const double w84 = c[55][l] * w83;
    const double w85 = w84 + 5e-06;
    const double w86 = c[15][l] * u6;
    const double w87 = w86 + u7;
    const double w88 = c[56][l] * w87;
    const double w89 = lane_cos(w88);
    const double w90 = x0 * w89;
    const double w91 = c[51][l] * x2;
    const double w92 = x1 + w91;
    const double w93 = lane_sin(w88);
    const double w94 = w92 * w93;
    const double w95 = w90 + w94;
    const double w96 = w95 * w95;
    const double w97 = w92 * w89;
    const double w98 = x0 * w93;
    const double w99 = -w98;
    const double w100 = w97 + w99;
    const double w101 = w100 * w100;
    const double w102 = w96 + w101;
    const double w103 = w102 * w102;
    const double w104 = w103 + c[57][l];
    const double w105 = sqrt(w104);
    const double w106 = sqrt(w105);
    const double w107 = 1.0 / w106;
    const double w108 = w95 * w107;
    const double w109 = lane_min(w85, w108);
    const double w110 = -w85;
    const double w111 = lane_max(w110, w109);
    const double w112 = c[58][l] * w83;
    const double w113 = w112 + 0.5;
    const double w114 = (-100000.0) * w111;
    const double w115 = w113 + w114;
    const double w116 = lane_max(0.0, w115);
    const double w117 = w116 * w116;
    const double w118 = w116 * w117;
    const double w119 = (-0.5) * w116;
    const double w120 = w119 + 1.0;
    const double w121 = w118 * w120;
    const double w122 = 100000.0 * w111;
    const double w123 = w113 + w122;
    const double w124 = lane_max(0.0, w123);
    const double w125 = w124 * w124;
    const double w126 = w124 * w125;
    const double w127 = (-0.5) * w124;
    const double w128 = w127 + 1.0;
    const double w129 = w126 * w128;
    const double w130 = 1e-05 * w121;
    const double w131 = w111 + w130;
    const double w132 = (-1e-05) * w129;
    const double w133 = w131 + w132;
    const double w134 = w133 * w133;
    const double w135 = -w134;
    const double w136 = w135 + 1.0;
    const double w137 = sqrt(w136);
    const double w138 = w137 + 5e-06;
    const double w139 = c[17][l] * w79;
    const double w140 = w139 + c[16][l];
    const double w141 = lane_max(0.0, w140);
    const double w142 = w96 + c[61][l];
    const double w143 = sqrt(w142);
    const double w144 = 1.0 / w143;
    const double w145 = w100 * w144;
    const double w146 = w141 * w145;
    const double w147 = w146 * w83;
    const double w148 = c[54][l] * w147;
    const double w149 = lane_min(w148, c[59][l]);
    const double w150 = lane_max(c[60][l], w149);
    const double w151 = c[21][l] * w150;
    const double w152 = lane_atan(w151);
    const double w153 = c[63][l] * w150;
    const double w154 = c[62][l] * w152;
    const double w155 = w153 + w154;
    const double w156 = c[21][l] * w155;
    const double w157 = lane_atan(w156);
    const double w158 = c[22][l] * w157;
    const double w159 = lane_sin(w158);
    const double w160 = w101 + w142;
    const double w161 = sqrt(w160);
    const double w162 = w159 * w161;
    const double w163 = w162 * w107;
    const double w164 = c[23][l] * w163;
    const double w165 = lane_min(w138, w164);
    const double w166 = -w138;
    const double w167 = lane_max(w166, w165);
    const double w168 = (-100000.0) * w137;
    const double w169 = w168 + 0.5;
    const double w170 = (-100000.0) * w167;
    const double w171 = w169 + w170;
    const double w172 = lane_max(0.0, w171);
    const double w173 = w172 * w172;
    const double w174 = w172 * w173;
    const double w175 = (-0.5) * w172;
    const double w176 = w175 + 1.0;
    const double w177 = w174 * w176;
    const double w178 = 100000.0 * w167;
    const double w179 = w169 + w178;
    const double w180 = lane_max(0.0, w179);
    const double w181 = w180 * w180;
    const double w182 = w180 * w181;
    const double w183 = (-0.5) * w180;
    const double w184 = w183 + 1.0;
    const double w185 = w182 * w184;
    const double w186 = 1e-05 * w177;
    const double w187 = w167 + w186;
    const double w188 = (-1e-05) * w185;
    const double w189 = w187 + w188;
    const double w190 = w79 * w189;
    const double w191 = w190 * w82;
    const double w192 = w191 * w93;
    const double w193 = w79 * w133;
    const double w194 = w193 * w82;
    const double w195 = w194 * w89;
    const double w196 = c[51][l] * w67;
    const double w197 = w196 + w75;
    const double w198 = c[66][l] * w197;
    const double w199 = lane_max(0.0, w198);
    const double w200 = c[7][l] * w199;
    const double w201 = w200 + c[6][l];
    const double w202 = lane_max(0.001, w201);
    const double w203 = c[8][l] * w202;
    const double w204 = w203 + c[67][l];
    const double w205 = u4 * w204;
    const double w206 = 1.0 / w202;
    const double w207 = w205 + c[12][l];
    const double w208 = w207 * w206;
    const double w209 = c[68][l] * w208;
    const double w210 = w209 + 5e-06;
    const double w211 = c[46][l] * x2;
    const double w212 = x1 + w211;
    const double w213 = c[70][l] * x0;
    const double w214 = c[71][l] * x2;
    const double w215 = w213 + w214;
    const double w216 = c[69][l] * w212;
    const double w217 = w215 + w216;
    const double w218 = w217 * w217;
    const double w219 = c[72][l] * x0;
    const double w220 = c[73][l] * x2;
    const double w221 = w219 + w220;
    const double w222 = c[70][l] * w212;
    const double w223 = w221 + w222;
    const double w224 = w223 * w223;
    const double w225 = w218 + w224;
    const double w226 = w225 * w225;
    const double w227 = w226 + c[57][l];
    const double w228 = sqrt(w227);
    const double w229 = sqrt(w228);
    const double w230 = 1.0 / w229;
    const double w231 = w217 * w230;
    const double w232 = lane_min(w210, w231);
    const double w233 = -w210;
    const double w234 = lane_max(w233, w232);
    const double w235 = c[74][l] * w208;
    const double w236 = w235 + 0.5;
    const double w237 = (-100000.0) * w234;
    const double w238 = w236 + w237;
    const double w239 = lane_max(0.0, w238);
    const double w240 = w239 * w239;
    const double w241 = w239 * w240;
    const double w242 = (-0.5) * w239;
    const double w243 = w242 + 1.0;
    const double w244 = w241 * w243;
    const double w245 = 100000.0 * w234;
    const double w246 = w236 + w245;
    const double w247 = lane_max(0.0, w246);
    const double w248 = w247 * w247;
    const double w249 = w247 * w248;
    const double w250 = (-0.5) * w247;
    const double w251 = w250 + 1.0;
    const double w252 = w249 * w251;
    const double w253 = 1e-05 * w244;
    const double w254 = w234 + w253;
    const double w255 = (-1e-05) * w252;
    const double w256 = w254 + w255;
    const double w257 = w199 * w256;
    const double w258 = w257 * w202;
    const double w259 = w256 * w256;
    const double w260 = -w259;
    const double w261 = w260 + 1.0;
    const double w262 = sqrt(w261);
    const double w263 = w262 + 5e-06;
    const double w264 = c[5][l] * w199;
    const double w265 = w264 + c[4][l];
    const double w266 = lane_max(0.0, w265);
    const double w267 = w218 + c[61][l];
    const double w268 = sqrt(w267);
    const double w269 = 1.0 / w268;
    const double w270 = w223 * w269;
    const double w271 = w266 * w270;
    const double w272 = w271 * w206;
    const double w273 = c[68][l] * w272;
    const double w274 = lane_min(w273, c[76][l]);
    const double w275 = lane_max(c[77][l], w274);
    const double w276 = c[9][l] * w275;
    const double w277 = lane_atan(w276);
    const double w278 = c[78][l] * w275;
    const double w279 = c[79][l] * w277;
    const double w280 = w278 + w279;
    const double w281 = c[9][l] * w280;
    const double w282 = lane_atan(w281);
    const double w283 = c[10][l] * w282;
    const double w284 = lane_sin(w283);
    const double w285 = w224 + w267;
    const double w286 = sqrt(w285);
    const double w287 = w284 * w286;
    const double w288 = w287 * w230;
    const double w289 = c[11][l] * w288;
    const double w290 = lane_min(w263, w289);
    const double w291 = -w263;
    const double w292 = lane_max(w291, w290);
    const double w293 = (-100000.0) * w262;
    const double w294 = w293 + 0.5;
    const double w295 = (-100000.0) * w292;
    const double w296 = w294 + w295;
    const double w297 = lane_max(0.0, w296);
    const double w298 = w297 * w297;
    const double w299 = w297 * w298;
    const double w300 = (-0.5) * w297;
    const double w301 = w300 + 1.0;
    const double w302 = w299 * w301;
    const double w303 = 100000.0 * w292;
    const double w304 = w294 + w303;
    const double w305 = lane_max(0.0, w304);
    const double w306 = w305 * w305;
    const double w307 = w305 * w306;
    const double w308 = (-0.5) * w305;
    const double w309 = w308 + 1.0;
    const double w310 = w307 * w309;
    const double w311 = 1e-05 * w302;
    const double w312 = w292 + w311;
    const double w313 = (-1e-05) * w310;
    const double w314 = w312 + w313;
    const double w315 = w199 * w314;
    const double w316 = w315 * w202;
    const double w317 = c[75][l] * w258;
    const double w318 = c[81][l] * w316;
    const double w319 = w317 + w318;
    const double w320 = c[13][l] * w202;
    const double w321 = w320 + c[82][l];
    const double w322 = u5 * w321;
    const double w323 = w322 + c[14][l];
    const double w324 = w323 * w206;
    const double w325 = c[83][l] * w324;
    const double w326 = w325 + 5e-06;
    const double w327 = c[84][l] * x2;
    const double w328 = w213 + w327;
    const double w329 = c[72][l] * w212;
    const double w330 = w328 + w329;
    const double w331 = w330 * w330;
    const double w332 = c[69][l] * x0;
    const double w333 = c[85][l] * x2;
    const double w334 = w332 + w333;
    const double w335 = w334 + w222;
    const double w336 = w335 * w335;
    const double w337 = w331 + w336;
    const double w338 = w337 * w337;
    const double w339 = w338 + c[57][l];
    const double w340 = sqrt(w339);
    const double w341 = sqrt(w340);
    const double w342 = 1.0 / w341;
    const double w343 = w330 * w342;
    const double w344 = lane_min(w326, w343);
    const double w345 = -w326;
    const double w346 = lane_max(w345, w344);
    const double w347 = c[86][l] * w324;
    const double w348 = w347 + 0.5;
    const double w349 = (-100000.0) * w346;
    const double w350 = w348 + w349;
    const double w351 = lane_max(0.0, w350);
    const double w352 = w351 * w351;
    const double w353 = w351 * w352;
    const double w354 = (-0.5) * w351;
    const double w355 = w354 + 1.0;
    const double w356 = w353 * w355;
    const double w357 = 100000.0 * w346;
    const double w358 = w348 + w357;
    const double w359 = lane_max(0.0, w358);
    const double w360 = w359 * w359;
    const double w361 = w359 * w360;
    const double w362 = (-0.5) * w359;
    const double w363 = w362 + 1.0;
    const double w364 = w361 * w363;
    const double w365 = 1e-05 * w356;
    const double w366 = w346 + w365;
    const double w367 = (-1e-05) * w364;
    const double w368 = w366 + w367;
    const double w369 = w199 * w368;
    const double w370 = w369 * w202;
    const double w371 = w368 * w368;
    const double w372 = -w371;
    const double w373 = w372 + 1.0;
    const double w374 = sqrt(w373);
    const double w375 = w374 + 5e-06;
    const double w376 = w331 + c[61][l];
    const double w377 = sqrt(w376);
    const double w378 = 1.0 / w377;
    const double w379 = w335 * w378;
    const double w380 = w266 * w379;
    const double w381 = w380 * w206;
    const double w382 = c[83][l] * w381;
    const double w383 = lane_min(w382, c[76][l]);
    const double w384 = lane_max(c[77][l], w383);
    const double w385 = c[9][l] * w384;
    const double w386 = lane_atan(w385);
    const double w387 = c[78][l] * w384;
    const double w388 = c[79][l] * w386;
    const double w389 = w387 + w388;
    const double w390 = c[9][l] * w389;
    const double w391 = lane_atan(w390);
    const double w392 = c[10][l] * w391;
    const double w393 = lane_sin(w392);
    const double w394 = w336 + w376;
    const double w395 = sqrt(w394);
    const double w396 = w393 * w395;
    const double w397 = w396 * w342;
    const double w398 = c[11][l] * w397;
    const double w399 = lane_min(w375, w398);
    const double w400 = -w375;
    const double w401 = lane_max(w400, w399);
    const double w402 = (-100000.0) * w374;
    const double w403 = w402 + 0.5;
    const double w404 = (-100000.0) * w401;
    const double w405 = w403 + w404;
    const double w406 = lane_max(0.0, w405);
    const double w407 = w406 * w406;
    const double w408 = w406 * w407;
    const double w409 = (-0.5) * w406;
    const double w410 = w409 + 1.0;
    const double w411 = w408 * w410;
    const double w412 = 100000.0 * w401;
    const double w413 = w403 + w412;
    const double w414 = lane_max(0.0, w413);
    const double w415 = w414 * w414;
    const double w416 = w414 * w415;
    const double w417 = (-0.5) * w414;
    const double w418 = w417 + 1.0;
    const double w419 = w416 * w418;
    const double w420 = 1e-05 * w411;
    const double w421 = w401 + w420;
    const double w422 = (-1e-05) * w419;
    const double w423 = w421 + w422;
    const double w424 = w199 * w423;
    const double w425 = w424 * w202;
    const double w426 = c[99][l] * x2;
    const double w427 = x1 + w426;
    const double w428 = w427 + w56;
    const double w429 = lane_atan2(w428, w21);
    const double w430 = c[100][l] * u6;
    const double w431 = w430 + u8;
    const double w432 = c[101][l] * w431;
    const double w433 = w432 + w429;
    const double w434 = c[31][l] * w433;
    const double w435 = lane_min(c[96][l], w434);
    const double w436 = lane_max(c[97][l], w435);
    const double w437 = (-5.0) * w436;
    const double w438 = w437 + c[102][l];
    const double w439 = lane_max(0.0, w438);
    const double w440 = w439 * w439;
    const double w441 = w439 * w440;
    const double w442 = (-0.5) * w439;
    const double w443 = w442 + 1.0;
    const double w444 = w441 * w443;
    const double w445 = 5.0 * w436;
    const double w446 = w445 + c[102][l];
    const double w447 = lane_max(0.0, w446);
    const double w448 = w447 * w447;
    const double w449 = w447 * w448;
    const double w450 = (-0.5) * w447;
    const double w451 = w450 + 1.0;
    const double w452 = w449 * w451;
    const double w453 = w428 * w428;
    const double w454 = 0.2 * w444;
    const double w455 = w436 + w454;
    const double w456 = (-0.2) * w452;
    const double w457 = w455 + w456;
    const double w458 = w20 + w453;
    const double w459 = w457 * w458;
    const double w460 = sqrt(w59);
    const double w461 = w460 * x2;
    const double w462 = lane_atan2(w57, w61);
    const double w463 = c[25][l] * w431;
    const double w464 = c[24][l] * w462;
    const double w465 = w463 + w464;
    const double w466 = w59 * w465;
    const double w467 = w194 * w93;
    const double w468 = w191 * w89;
    const double w469 = c[28][l] * u9;
    const double w470 = c[30][l] * w431;
    const double w471 = w469 + w470;
    const double w472 = c[29][l] * w462;
    const double w473 = w471 + w472;
    const double w474 = w59 * w473;
    const double w475 = x0 * w0;
    const double w476 = x1 * w2;
    const double w477 = -w476;
    const double w478 = w475 + w477;
    const double w479 = x0 * w2;
    const double w480 = x1 * w0;
    const double w481 = w479 + w480;
    const double w482 = lane_atan(w270);
    const double w483 = c[8][l] * w258;
    const double w484 = c[8][l] * w316;
    const double w485 = lane_atan(w379);
    const double w486 = c[13][l] * w370;
    const double w487 = c[13][l] * w425;
    const double w488 = lane_atan(w145);
    const double w489 = c[20][l] * w194;
    const double w490 = c[64][l] * w191;
    const double w491 = c[44][l] * w59;
    const double w492 = c[89][l] * w59;
    const double w493 = c[106][l] * w461;
    const double w494 = c[43][l] * w466;
    const double w495 = w493 + w494;
    const double w496 = c[26][l] * u9;
    const double w497 = c[27][l] * w462;
    const double w498 = w496 + w497;
    const double w499 = w59 * w498;
    const double w500 = c[127][l] * w461;
    const double w501 = c[113][l] * w499;
    const double w502 = w500 + w501;
    const double w503 = c[128][l] * w461;
    const double w504 = c[113][l] * w474;
    const double w505 = w503 + w504;
    const double w506 = c[103][l] * w459;
    const double w507 = c[40][l] * w50;
    const double w508 = w481 * w481;
    const double w509 = w478 * w478;
    const double w510 = w508 + 1e-12;
    const double w511 = w510 + w509;
    const double w512 = sqrt(w511);
    const double w513 = c[90][l] * w63;
    const double w514 = u2 + w513;
    const double w515 = c[65][l] * w195;
    const double w516 = w514 + w515;
    const double w517 = c[107][l] * w370;
    const double w518 = w516 + w517;
    const double w519 = c[64][l] * w192;
    const double w520 = w518 + w519;
    const double w521 = -w319;
    const double w522 = w520 + w521;
    const double w523 = c[129][l] * w425;
    const double w524 = w522 + w523;
    const double w525 = c[81][l] * w258;
    const double w526 = u10 + w525;
    const double w527 = c[88][l] * w370;
    const double w528 = w526 + w527;
    const double w529 = c[104][l] * w459;
    const double w530 = w528 + w529;
    const double w531 = c[65][l] * w467;
    const double w532 = w530 + w531;
    const double w533 = w532 + w495;
    const double w534 = c[130][l] * w316;
    const double w535 = w533 + w534;
    const double w536 = c[107][l] * w425;
    const double w537 = w535 + w536;
    const double w538 = c[131][l] * w468;
    const double w539 = w537 + w538;
    const double w540 = c[98][l] * u10;
    const double w541 = c[134][l] * w258;
    const double w542 = w540 + w541;
    const double w543 = c[132][l] * w370;
    const double w544 = w542 + w543;
    const double w545 = c[114][l] * w459;
    const double w546 = w544 + w545;
    const double w547 = c[136][l] * w467;
    const double w548 = w546 + w547;
    const double w549 = w548 + w505;
    const double w550 = c[135][l] * w316;
    const double w551 = w549 + w550;
    const double w552 = c[115][l] * w319;
    const double w553 = w551 + w552;
    const double w554 = c[133][l] * w425;
    const double w555 = w553 + w554;
    const double w556 = c[137][l] * w468;
    const double w557 = w555 + w556;
    const double w558 = c[91][l] * w524;
    const double w559 = c[91][l] * w539;
    const double w560 = c[138][l] * u10;
    const double w561 = c[141][l] * w258;
    const double w562 = w560 + w561;
    const double w563 = c[145][l] * w370;
    const double w564 = w562 + w563;
    const double w565 = c[139][l] * w459;
    const double w566 = w564 + w565;
    const double w567 = c[143][l] * w467;
    const double w568 = w566 + w567;
    const double w569 = -w502;
    const double w570 = w568 + w569;
    const double w571 = c[142][l] * w316;
    const double w572 = w570 + w571;
    const double w573 = c[140][l] * w425;
    const double w574 = w572 + w573;
    const double w575 = c[144][l] * w468;
    const double w576 = w574 + w575;
    const double w577 = -w73;
    const double w578 = c[146][l] * w50;
    const double w579 = w577 + w578;
    const double w580 = c[148][l] * w195;
    const double w581 = w579 + w580;
    const double w582 = c[149][l] * w258;
    const double w583 = w581 + w582;
    const double w584 = c[150][l] * w370;
    const double w585 = w583 + w584;
    const double w586 = c[144][l] * w192;
    const double w587 = w585 + w586;
    const double w588 = c[147][l] * w316;
    const double w589 = w587 + w588;
    const double w590 = c[145][l] * w425;
    const double w591 = w589 + w590;
    const double w592 = w512 + c[151][l];
    const double w593 = fabs(x4);
    const double w594 = w593 + c[152][l];
    const double w595 = fabs(x5);
    const double w596 = w595 + c[153][l];
    *y0 = w199;
    *y1 = w482;
    *y2 = w483;
    *y3 = w484;
    *y4 = w199;
    *y5 = w485;
    *y6 = w486;
    *y7 = w487;
    *y8 = w79;
    *y9 = w488;
    *y10 = w489;
    *y11 = w490;
    *y12 = c[0][l];
    *y13 = w462;
    *y14 = c[42][l];
    *y15 = w491;
    *y16 = w492;
    *y17 = w495;
    *y18 = w502;
    *y19 = w72;
    *y20 = w505;
    *y21 = w429;
    *y22 = w457;
    *y23 = w506;
    *y24 = w26;
    *y25 = w49;
    *y26 = w507;
    *y27 = w512;
    *y28 = w524;
    *y29 = w539;
    *y30 = w557;
    *y31 = w558;
    *y32 = w559;
    *y33 = w67;
    *y34 = w576;
    *y35 = w591;
    *y36 = w592;
    *y37 = w594;
    *y38 = w596;
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

#else
static void constants(const lanes *p, lanes *c)
{
    LANE_LOOP {
        const double w0 = p[37][l] * p[38][l];
        const double w1 = p[23][l] + 0.1;
        const double w2 = -w1;
        const double w3 = p[3][l] * p[21][l];
        const double w4 = w3 + p[20][l];
        const double w5 = -p[19][l];
        const double w6 = 1.0 + w5;
        const double w7 = p[18][l] * p[18][l];
        const double w8 = w7 + 1e-12;
        const double w9 = sqrt(w8);
        const double w10 = p[17][l] * w9;
        const double w11 = p[2][l] / w10;
        const double w12 = 2.0 * w11;
        const double w13 = w6 * p[12][l];
        const double w14 = w4 + w13;
        const double w15 = (-5.0) * p[23][l];
        const double w16 = w15 + 0.5;
        const double w17 = p[24][l] * 0.5;
        const double w18 = p[18][l] * w17;
        const double w19 = p[25][l] * w18;
        const double w20 = -w19;
        const double w21 = p[33][l] + 0.1;
        const double w22 = -w21;
        const double w23 = p[32][l] * p[12][l];
        const double w24 = p[31][l] + w23;
        const double w25 = lane_min(w21, w24);
        const double w26 = lane_max(w22, w25);
        const double w27 = (-5.0) * p[33][l];
        const double w28 = 5.0 * w26;
        const double w29 = -w28;
        const double w30 = w27 + w29;
        const double w31 = w30 + 0.5;
        const double w32 = lane_max(0.0, w31);
        const double w33 = w32 * w32;
        const double w34 = w32 * w33;
        const double w35 = 0.2 * w34;
        const double w36 = 0.5 * w32;
        const double w37 = -w36;
        const double w38 = 1.0 + w37;
        const double w39 = w35 * w38;
        const double w40 = w26 + w39;
        const double w41 = w27 + w28;
        const double w42 = w41 + 0.5;
        const double w43 = lane_max(0.0, w42);
        const double w44 = w43 * w43;
        const double w45 = w43 * w44;
        const double w46 = 0.2 * w45;
        const double w47 = 0.5 * w43;
        const double w48 = -w47;
        const double w49 = 1.0 + w48;
        const double w50 = w46 * w49;
        const double w51 = -w50;
        const double w52 = w40 + w51;
        const double w53 = 0.5 * p[26][l];
        const double w54 = -p[0][l];
        const double w55 = p[18][l] * w53;
        const double w56 = w52 * w55;
        const double w57 = -w56;
        const double w58 = lane_cos(p[12][l]);
        const double w59 = p[11][l] * w58;
        const double w60 = lane_sin(p[12][l]);
        const double w61 = p[15][l] * w60;
        const double w62 = w59 + w61;
        const double w63 = p[39][l] * w58;
        const double w64 = p[40][l] * w60;
        const double w65 = w63 + w64;
        const double w66 = w65 * w19;
        const double w67 = p[30][l] * w55;
        const double w68 = p[28][l] * p[12][l];
        const double w69 = p[27][l] + w68;
        const double w70 = p[29][l] * p[3][l];
        const double w71 = w69 + w70;
        const double w72 = w71 * w67;
        const double w73 = p[2][l] * p[42][l];
        const double w74 = w73 * w58;
        const double w75 = p[36][l] * w58;
        const double w76 = p[41][l] * w60;
        const double w77 = w75 + w76;
        const double w78 = -w77;
        const double w79 = w62 + w78;
        const double w80 = 1.0 / w79;
        const double w81 = 1.0 / p[61][l];
        const double w82 = p[66][l] * w81;
        const double w83 = p[6][l] * p[55][l];
        const double w84 = w83 + p[7][l];
        const double w85 = -p[56][l];
        const double w86 = 1.0 + w85;
        const double w87 = w84 * w86;
        const double w88 = lane_cos(w87);
        const double w89 = lane_sin(w87);
        const double w90 = p[16][l] * p[16][l];
        const double w91 = w90 * w90;
        const double w92 = -w89;
        const double w93 = (-100000.0) * w82;
        const double w94 = p[63][l] + -1.0;
        const double w95 = lane_max(1e-12, w94);
        const double w96 = sqrt(w95);
        const double w97 = p[62][l] * w96;
        const double w98 = 1.0 / w97;
        const double w99 = -w98;
        const double w100 = 1e-06 * w90;
        const double w101 = 1.0 / p[62][l];
        const double w102 = w101 * p[63][l];
        const double w103 = -w94;
        const double w104 = w86 * p[61][l];
        const double w105 = w89 * w104;
        const double w106 = w88 * p[61][l];
        const double w107 = -w106;
        const double w108 = w80 * 0.5;
        const double w109 = -w108;
        const double w110 = -p[52][l];
        const double w111 = p[4][l] * p[47][l];
        const double w112 = p[4][l] * w110;
        const double w113 = w112 + p[52][l];
        const double w114 = 1.0 / p[47][l];
        const double w115 = lane_sin(p[13][l]);
        const double w116 = p[14][l] * 0.5;
        const double w117 = lane_cos(p[13][l]);
        const double w118 = w117 * w116;
        const double w119 = -w115;
        const double w120 = w119 * w116;
        const double w121 = (-100000.0) * w114;
        const double w122 = w117 * p[47][l];
        const double w123 = p[49][l] + -1.0;
        const double w124 = lane_max(1e-12, w123);
        const double w125 = sqrt(w124);
        const double w126 = p[48][l] * w125;
        const double w127 = 1.0 / w126;
        const double w128 = -w127;
        const double w129 = -p[49][l];
        const double w130 = 1.0 + w129;
        const double w131 = 1.0 / p[48][l];
        const double w132 = w131 * p[49][l];
        const double w133 = w115 * p[47][l];
        const double w134 = -w133;
        const double w135 = -p[54][l];
        const double w136 = p[5][l] * p[53][l];
        const double w137 = p[5][l] * w135;
        const double w138 = w137 + p[54][l];
        const double w139 = 1.0 / p[53][l];
        const double w140 = -w116;
        const double w141 = w117 * w140;
        const double w142 = w115 * w140;
        const double w143 = (-100000.0) * w139;
        const double w144 = w117 * p[53][l];
        const double w145 = w115 * p[53][l];
        const double w146 = w52 * w52;
        const double w147 = w146 * p[35][l];
        const double w148 = p[34][l] + w147;
        const double w149 = w148 * w55;
        const double w150 = -w149;
        const double w151 = 1.0 / p[38][l];
        const double w152 = w151 * w105;
        const double w153 = w151 * w107;
        const double w154 = w151 * -1.0;
        const double w155 = w151 * w150;
        const double w156 = w151 * p[2][l];
        const double w157 = 0.5 * p[84][l];
        const double w158 = p[81][l] + 0.1;
        const double w159 = -w158;
        const double w160 = p[80][l] * w60;
        const double w161 = p[79][l] * w58;
        const double w162 = -w161;
        const double w163 = w160 + w162;
        const double w164 = p[6][l] * p[67][l];
        const double w165 = -w164;
        const double w166 = p[8][l] + w165;
        const double w167 = w166 * p[83][l];
        const double w168 = -w167;
        const double w169 = (-5.0) * p[81][l];
        const double w170 = w169 + 0.5;
        const double w171 = p[85][l] * w157;
        const double w172 = p[18][l] * w171;
        const double w173 = -w172;
        const double w174 = p[69][l] * p[71][l];
        const double w175 = 0.25 * p[26][l];
        const double w176 = p[18][l] * w175;
        const double w177 = w174 * w176;
        const double w178 = p[70][l] * w166;
        const double w179 = -w144;
        const double w180 = w89 * p[61][l];
        const double w181 = w88 * w104;
        const double w182 = w151 * w173;
        const double w183 = w151 * w145;
        const double w184 = w151 * w177;
        const double w185 = w151 * w55;
        const double w186 = w151 * w179;
        const double w187 = w151 * p[10][l];
        const double w188 = p[71][l] * p[71][l];
        const double w189 = p[77][l] * w188;
        const double w190 = w189 * w176;
        const double w191 = p[71][l] * w55;
        const double w192 = p[75][l] * p[9][l];
        const double w193 = p[78][l] * w166;
        const double w194 = w192 + w193;
        const double w195 = w163 * w172;
        const double w196 = p[10][l] * w161;
        const double w197 = -w195;
        const double w198 = -w196;
        const double w199 = 0.5 * p[14][l];
        const double w200 = -w199;
        const double w201 = -w62;
        const double w202 = w62 * w145;
        const double w203 = w62 * w179;
        const double w204 = 1.0 / p[89][l];
        const double w205 = w204 * w190;
        const double w206 = w204 * w191;
        const double w207 = w204 * w197;
        const double w208 = w204 * w200;
        const double w209 = w204 * w199;
        const double w210 = w204 * w201;
        const double w211 = w204 * w78;
        const double w212 = w204 * w202;
        const double w213 = w204 * w203;
        const double w214 = w204 * w198;
        const double w215 = w188 * w176;
        const double w216 = p[74][l] * w215;
        const double w217 = p[72][l] * p[9][l];
        const double w218 = p[77][l] * w215;
        const double w219 = -w145;
        const double w220 = -w122;
        const double w221 = -w180;
        const double w222 = -w181;
        const double w223 = w199 * w144;
        const double w224 = w199 * w145;
        const double w225 = w223 + w202;
        const double w226 = w224 + w203;
        const double w227 = w201 * w133;
        const double w228 = w201 * w122;
        const double w229 = w78 * w180;
        const double w230 = w78 * w181;
        const double w231 = p[10][l] * p[79][l];
        const double w232 = w231 * w60;
        const double w233 = p[79][l] * w172;
        const double w234 = w60 * w233;
        const double w235 = p[80][l] * w172;
        const double w236 = w58 * w235;
        const double w237 = w234 + w236;
        const double w238 = -w237;
        const double w239 = p[11][l] * p[47][l];
        const double w240 = w60 * w239;
        const double w241 = w115 * w240;
        const double w242 = p[15][l] * p[53][l];
        const double w243 = w115 * w242;
        const double w244 = w58 * w243;
        const double w245 = p[36][l] * p[61][l];
        const double w246 = w89 * w245;
        const double w247 = w60 * w246;
        const double w248 = w117 * w240;
        const double w249 = p[11][l] * p[53][l];
        const double w250 = w60 * w249;
        const double w251 = w117 * w250;
        const double w252 = p[36][l] * w104;
        const double w253 = w60 * w252;
        const double w254 = w88 * w253;
        const double w255 = p[15][l] * w58;
        const double w256 = w255 * w144;
        const double w257 = -w256;
        const double w258 = w251 + w257;
        const double w259 = w255 * w133;
        const double w260 = -w259;
        const double w261 = w241 + w260;
        const double w262 = w255 * w122;
        const double w263 = -w262;
        const double w264 = w248 + w263;
        const double w265 = p[41][l] * w58;
        const double w266 = w265 * w180;
        const double w267 = -w266;
        const double w268 = w247 + w267;
        const double w269 = w265 * w181;
        const double w270 = -w269;
        const double w271 = w254 + w270;
        const double w272 = p[11][l] * w60;
        const double w273 = w272 * w145;
        const double w274 = -w273;
        const double w275 = w244 + w274;
        const double w276 = p[15][l] * p[47][l];
        const double w277 = w58 * w276;
        const double w278 = w117 * w277;
        const double w279 = w63 * w19;
        const double w280 = w64 * w19;
        const double w281 = w279 + w280;
        const double w282 = -w281;
        const double w283 = w58 * w242;
        const double w284 = w117 * w283;
        const double w285 = p[41][l] * p[61][l];
        const double w286 = w88 * w285;
        const double w287 = w58 * w286;
        const double w288 = w255 * p[47][l];
        const double w289 = w115 * w288;
        const double w290 = -w289;
        const double w291 = w241 + w290;
        const double w292 = w89 * w252;
        const double w293 = w60 * w292;
        const double w294 = w265 * w104;
        const double w295 = w89 * w294;
        const double w296 = -w295;
        const double w297 = w293 + w296;
        const double w298 = p[36][l] * w106;
        const double w299 = w60 * w298;
        const double w300 = -w299;
        const double w301 = w287 + w300;
        const double w302 = w272 * w122;
        const double w303 = -w302;
        const double w304 = w278 + w303;
        const double w305 = w272 * w144;
        const double w306 = -w305;
        const double w307 = w284 + w306;
        const double w308 = -p[86][l];
        const double w309 = (-0.5) * p[87][l];
        const double w310 = -p[88][l];
        const double w311 = w82 * w81;
        const double w312 = p[60][l] * w80;
        const double w313 = p[61][l] * w312;
        const double w314 = w311 * w313;
        const double w315 = -w314;
        const double w316 = (-100000.0) * w314;
        const double w317 = -w316;
        const double w318 = p[58][l] * w80;
        const double w319 = w81 * w81;
        const double w320 = w319 * w313;
        const double w321 = -w320;
        const double w322 = p[62][l] * p[62][l];
        const double w323 = p[63][l] * p[62][l];
        const double w324 = w101 * w323;
        const double w325 = p[64][l] * p[62][l];
        const double w326 = p[65][l] * w325;
        const double w327 = p[65][l] * 0.5;
        const double w328 = -w327;
        const double w329 = w89 * w86;
        const double w330 = -w88;
        const double w331 = w114 * w114;
        const double w332 = p[46][l] * w108;
        const double w333 = p[47][l] * w332;
        const double w334 = w331 * w333;
        const double w335 = p[4][l] * w333;
        const double w336 = w335 * w114;
        const double w337 = -w336;
        const double w338 = -w333;
        const double w339 = p[44][l] * w108;
        const double w340 = -w339;
        const double w341 = p[48][l] * p[48][l];
        const double w342 = p[49][l] * p[48][l];
        const double w343 = w131 * w342;
        const double w344 = p[50][l] * p[48][l];
        const double w345 = p[51][l] * w344;
        const double w346 = p[51][l] * 0.5;
        const double w347 = -w346;
        const double w348 = w139 * w139;
        const double w349 = p[53][l] * w332;
        const double w350 = w348 * w349;
        const double w351 = p[5][l] * w349;
        const double w352 = w351 * w139;
        const double w353 = -w352;
        const double w354 = -w349;
        const double w355 = -w150;
        const double w356 = w151 * w329;
        const double w357 = w151 * w330;
        const double w358 = w151 * w355;
        const double w359 = 5.0 * p[82][l];
        const double w360 = 0.5 * w359;
        const double w361 = 0.2 * w360;
        const double w362 = 2.0 * w359;
        const double w363 = -w361;
        const double w364 = -w363;
        const double w365 = w175 * 0.5;
        const double w366 = w174 * p[18][l];
        const double w367 = w55 * p[68][l];
        const double w368 = -w117;
        const double w369 = w88 * w86;
        const double w370 = w151 * w115;
        const double w371 = w151 * w366;
        const double w372 = w151 * w367;
        const double w373 = w151 * w368;
        const double w374 = w189 * p[18][l];
        const double w375 = w191 * p[76][l];
        const double w376 = -w163;
        const double w377 = w62 * w115;
        const double w378 = w62 * w368;
        const double w379 = w204 * w374;
        const double w380 = w204 * w375;
        const double w381 = w204 * w376;
        const double w382 = w204 * w377;
        const double w383 = w204 * w378;
        const double w384 = w53 * 2.0;
        const double w385 = p[18][l] * w384;
        const double w386 = p[30][l] * w385;
        const double w387 = w71 * w386;
        const double w388 = w52 * w385;
        const double w389 = w88 * 2.0;
        const double w390 = w89 * 2.0;
        const double w391 = -w390;
        const double w392 = w389 * 0.5;
        const double w393 = w329 * p[61][l];
        const double w394 = w329 * w313;
        const double w395 = w330 * p[61][l];
        const double w396 = w330 * w313;
        const double w397 = w117 * 2.0;
        const double w398 = w115 * 2.0;
        const double w399 = -w398;
        const double w400 = w397 * 0.5;
        const double w401 = -w114;
        const double w402 = w117 * w338;
        const double w403 = w119 * p[47][l];
        const double w404 = w119 * w338;
        const double w405 = -w402;
        const double w406 = -w403;
        const double w407 = -w404;
        const double w408 = -w400;
        const double w409 = w117 * w354;
        const double w410 = w115 * w354;
        const double w411 = -w409;
        const double w412 = -w410;
        const double w413 = w148 * w385;
        const double w414 = w77 * w388;
        const double w415 = -w414;
        const double w416 = w172 * 2.0;
        const double w417 = -w416;
        const double w418 = w398 * 0.5;
        const double w419 = w368 * p[53][l];
        const double w420 = w368 * w354;
        const double w421 = -w418;
        const double w422 = w115 * w338;
        const double w423 = -w422;
        const double w424 = w62 * w388;
        const double w425 = -w424;
        const double w426 = w390 * 0.5;
        const double w427 = -w426;
        const double w428 = w89 * w313;
        const double w429 = w369 * p[61][l];
        const double w430 = w369 * w313;
        const double w431 = -w428;
        const double w432 = -w429;
        const double w433 = -w430;
        const double w434 = w151 * w393;
        const double w435 = w151 * w394;
        const double w436 = w151 * w395;
        const double w437 = w151 * w396;
        const double w438 = w151 * w220;
        const double w439 = w151 * w405;
        const double w440 = w151 * w406;
        const double w441 = w151 * w407;
        const double w442 = w151 * w411;
        const double w443 = w151 * w219;
        const double w444 = w151 * w412;
        const double w445 = w151 * w410;
        const double w446 = w151 * w417;
        const double w447 = w151 * w385;
        const double w448 = w151 * w419;
        const double w449 = w151 * w420;
        const double w450 = w151 * w134;
        const double w451 = w151 * w423;
        const double w452 = w151 * w221;
        const double w453 = w151 * w431;
        const double w454 = w151 * w432;
        const double w455 = w151 * w433;
        const double w456 = p[82][l] * w163;
        const double w457 = 5.0 * w456;
        const double w458 = 0.5 * w457;
        const double w459 = 0.2 * w458;
        const double w460 = 2.0 * w457;
        const double w461 = -w459;
        const double w462 = -w461;
        const double w463 = w163 * 2.0;
        const double w464 = w172 * w463;
        const double w465 = w376 * w172;
        const double w466 = w376 * w464;
        const double w467 = w115 * w62;
        const double w468 = w117 * w199;
        const double w469 = w467 + w468;
        const double w470 = w469 * 2.0;
        const double w471 = w117 * w62;
        const double w472 = w115 * w199;
        const double w473 = -w472;
        const double w474 = w471 + w473;
        const double w475 = w474 * 2.0;
        const double w476 = w470 * 0.5;
        const double w477 = -w476;
        const double w478 = w130 * w114;
        const double w479 = p[48][l] * w114;
        const double w480 = p[49][l] * w479;
        const double w481 = w131 * w480;
        const double w482 = w200 * w122;
        const double w483 = w200 * w134;
        const double w484 = w468 + w467;
        const double w485 = w484 * 2.0;
        const double w486 = -w485;
        const double w487 = w485 * 0.5;
        const double w488 = w130 * w139;
        const double w489 = p[48][l] * w139;
        const double w490 = p[49][l] * w489;
        const double w491 = w131 * w490;
        const double w492 = w482 + w227;
        const double w493 = w483 + w228;
        const double w494 = w89 * w77;
        const double w495 = w494 * 2.0;
        const double w496 = w88 * w77;
        const double w497 = w496 * 2.0;
        const double w498 = w495 * 0.5;
        const double w499 = -w498;
        const double w500 = p[62][l] * w81;
        const double w501 = p[63][l] * w500;
        const double w502 = w101 * w501;
        const double w503 = w94 * w81;
        const double w504 = -w503;
        const double w505 = w204 * w465;
        const double w506 = w204 * w466;
        const double w507 = w446 + w506;
        const double w508 = w204 * w492;
        const double w509 = w204 * w493;
        const double w510 = w204 * w225;
        const double w511 = w204 * w226;
        const double w512 = w204 * w229;
        const double w513 = w204 * w230;
        c[0][l] = p[0][l];
        c[1][l] = p[1][l];
        c[2][l] = p[2][l];
        c[3][l] = p[10][l];
        c[4][l] = p[12][l];
        c[5][l] = p[22][l];
        c[6][l] = p[43][l];
        c[7][l] = p[44][l];
        c[8][l] = p[45][l];
        c[9][l] = p[46][l];
        c[10][l] = p[47][l];
        c[11][l] = p[48][l];
        c[12][l] = p[50][l];
        c[13][l] = p[51][l];
        c[14][l] = p[53][l];
        c[15][l] = p[57][l];
        c[16][l] = p[58][l];
        c[17][l] = p[59][l];
        c[18][l] = p[60][l];
        c[19][l] = p[61][l];
        c[20][l] = p[62][l];
        c[21][l] = p[64][l];
        c[22][l] = p[65][l];
        c[23][l] = p[68][l];
        c[24][l] = p[73][l];
        c[25][l] = p[76][l];
        c[26][l] = p[82][l];
        c[27][l] = w0;
        c[28][l] = w1;
        c[29][l] = w2;
        c[30][l] = w6;
        c[31][l] = w11;
        c[32][l] = w12;
        c[33][l] = w14;
        c[34][l] = w16;
        c[35][l] = w19;
        c[36][l] = w20;
        c[37][l] = w52;
        c[38][l] = w54;
        c[39][l] = w55;
        c[40][l] = w56;
        c[41][l] = w57;
        c[42][l] = w62;
        c[43][l] = w66;
        c[44][l] = w72;
        c[45][l] = w74;
        c[46][l] = w77;
        c[47][l] = w78;
        c[48][l] = w80;
        c[49][l] = w81;
        c[50][l] = w82;
        c[51][l] = w88;
        c[52][l] = w89;
        c[53][l] = w91;
        c[54][l] = w92;
        c[55][l] = w93;
        c[56][l] = w98;
        c[57][l] = w99;
        c[58][l] = w100;
        c[59][l] = w102;
        c[60][l] = w103;
        c[61][l] = w104;
        c[62][l] = w105;
        c[63][l] = w107;
        c[64][l] = w109;
        c[65][l] = w111;
        c[66][l] = w113;
        c[67][l] = w114;
        c[68][l] = w115;
        c[69][l] = w117;
        c[70][l] = w118;
        c[71][l] = w119;
        c[72][l] = w120;
        c[73][l] = w121;
        c[74][l] = w122;
        c[75][l] = w127;
        c[76][l] = w128;
        c[77][l] = w130;
        c[78][l] = w132;
        c[79][l] = w133;
        c[80][l] = w134;
        c[81][l] = w136;
        c[82][l] = w138;
        c[83][l] = w139;
        c[84][l] = w141;
        c[85][l] = w142;
        c[86][l] = w143;
        c[87][l] = w144;
        c[88][l] = w145;
        c[89][l] = w149;
        c[90][l] = w150;
        c[91][l] = w151;
        c[92][l] = w152;
        c[93][l] = w153;
        c[94][l] = w154;
        c[95][l] = w155;
        c[96][l] = w156;
        c[97][l] = w158;
        c[98][l] = w159;
        c[99][l] = w163;
        c[100][l] = w168;
        c[101][l] = w170;
        c[102][l] = w172;
        c[103][l] = w173;
        c[104][l] = w175;
        c[105][l] = w177;
        c[106][l] = w178;
        c[107][l] = w179;
        c[108][l] = w180;
        c[109][l] = w181;
        c[110][l] = w182;
        c[111][l] = w183;
        c[112][l] = w184;
        c[113][l] = w185;
        c[114][l] = w186;
        c[115][l] = w187;
        c[116][l] = w191;
        c[117][l] = w194;
        c[118][l] = w197;
        c[119][l] = w198;
        c[120][l] = w200;
        c[121][l] = w201;
        c[122][l] = w205;
        c[123][l] = w206;
        c[124][l] = w207;
        c[125][l] = w208;
        c[126][l] = w209;
        c[127][l] = w210;
        c[128][l] = w211;
        c[129][l] = w212;
        c[130][l] = w213;
        c[131][l] = w214;
        c[132][l] = w216;
        c[133][l] = w217;
        c[134][l] = w218;
        c[135][l] = w219;
        c[136][l] = w220;
        c[137][l] = w221;
        c[138][l] = w222;
        c[139][l] = w225;
        c[140][l] = w226;
        c[141][l] = w227;
        c[142][l] = w228;
        c[143][l] = w229;
        c[144][l] = w230;
        c[145][l] = w232;
        c[146][l] = w238;
        c[147][l] = w258;
        c[148][l] = w261;
        c[149][l] = w264;
        c[150][l] = w268;
        c[151][l] = w271;
        c[152][l] = w275;
        c[153][l] = w282;
        c[154][l] = w291;
        c[155][l] = w297;
        c[156][l] = w301;
        c[157][l] = w304;
        c[158][l] = w307;
        c[159][l] = w308;
        c[160][l] = w309;
        c[161][l] = w310;
        c[162][l] = w313;
        c[163][l] = w314;
        c[164][l] = w315;
        c[165][l] = w316;
        c[166][l] = w317;
        c[167][l] = w318;
        c[168][l] = w321;
        c[169][l] = w322;
        c[170][l] = w324;
        c[171][l] = w326;
        c[172][l] = w327;
        c[173][l] = w328;
        c[174][l] = w334;
        c[175][l] = w337;
        c[176][l] = w338;
        c[177][l] = w339;
        c[178][l] = w340;
        c[179][l] = w341;
        c[180][l] = w343;
        c[181][l] = w345;
        c[182][l] = w346;
        c[183][l] = w347;
        c[184][l] = w350;
        c[185][l] = w353;
        c[186][l] = w354;
        c[187][l] = w356;
        c[188][l] = w357;
        c[189][l] = w358;
        c[190][l] = w359;
        c[191][l] = w361;
        c[192][l] = w362;
        c[193][l] = w364;
        c[194][l] = w365;
        c[195][l] = w369;
        c[196][l] = w370;
        c[197][l] = w371;
        c[198][l] = w372;
        c[199][l] = w373;
        c[200][l] = w379;
        c[201][l] = w380;
        c[202][l] = w381;
        c[203][l] = w382;
        c[204][l] = w383;
        c[205][l] = w387;
        c[206][l] = w388;
        c[207][l] = w389;
        c[208][l] = w390;
        c[209][l] = w391;
        c[210][l] = w392;
        c[211][l] = w397;
        c[212][l] = w398;
        c[213][l] = w399;
        c[214][l] = w400;
        c[215][l] = w401;
        c[216][l] = w408;
        c[217][l] = w413;
        c[218][l] = w415;
        c[219][l] = w418;
        c[220][l] = w421;
        c[221][l] = w425;
        c[222][l] = w427;
        c[223][l] = w434;
        c[224][l] = w435;
        c[225][l] = w436;
        c[226][l] = w437;
        c[227][l] = w438;
        c[228][l] = w439;
        c[229][l] = w440;
        c[230][l] = w441;
        c[231][l] = w442;
        c[232][l] = w443;
        c[233][l] = w444;
        c[234][l] = w445;
        c[235][l] = w447;
        c[236][l] = w448;
        c[237][l] = w449;
        c[238][l] = w450;
        c[239][l] = w451;
        c[240][l] = w452;
        c[241][l] = w453;
        c[242][l] = w454;
        c[243][l] = w455;
        c[244][l] = w456;
        c[245][l] = w457;
        c[246][l] = w459;
        c[247][l] = w460;
        c[248][l] = w462;
        c[249][l] = w469;
        c[250][l] = w470;
        c[251][l] = w474;
        c[252][l] = w475;
        c[253][l] = w477;
        c[254][l] = w478;
        c[255][l] = w481;
        c[256][l] = w484;
        c[257][l] = w486;
        c[258][l] = w487;
        c[259][l] = w488;
        c[260][l] = w491;
        c[261][l] = w494;
        c[262][l] = w495;
        c[263][l] = w496;
        c[264][l] = w497;
        c[265][l] = w499;
        c[266][l] = w502;
        c[267][l] = w504;
        c[268][l] = w505;
        c[269][l] = w507;
        c[270][l] = w508;
        c[271][l] = w509;
        c[272][l] = w510;
        c[273][l] = w511;
        c[274][l] = w512;
        c[275][l] = w513;
    }
}

INLINE void rate0(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x2 = MOVE(x, S2);
    const double x5 = MOVE(x, S5);
    const double w0 = x2 * x1;
    const double w1 = lane_cos(x5);
    const double w2 = lane_sin(x5);
    const double w3 = c[0][l] * w1;
    const double w4 = c[1][l] * w2;
    const double w5 = w3 + w4;
    const double w6 = -w5;
    const double w7 = x0 + w6;
    const double w8 = w7 * w7;
    const double w9 = w8 + 0.0001;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = w11 + c[32][l];
    const double w13 = w12 * w12;
    const double w14 = w13 + 1e-08;
    const double w15 = sqrt(w14);
    const double w16 = 0.5 * w11;
    const double w17 = w16 + c[31][l];
    const double w18 = 0.5 * w15;
    const double w19 = w17 + w18;
    const double w20 = sqrt(w19);
    const double w21 = w8 + 1e-08;
    const double w22 = c[1][l] * w1;
    const double w23 = c[38][l] * w2;
    const double w24 = w22 + w23;
    const double w25 = -w24;
    const double w26 = x1 + w25;
    const double w27 = w26 * w26;
    const double w28 = w21 + w27;
    const double w29 = w28 * w7;
    const double w30 = sqrt(w21);
    const double w31 = 1.0 / w30;
    const double w32 = w29 * w31;
    const double w33 = c[41][l] * w32;
    const double w34 = w33 + c[27][l];
    const double w35 = c[44][l] * w28;
    const double w36 = w35 + c[45][l];
    const double w37 = c[46][l] * x2;
    const double w38 = x1 + w37;
    const double w39 = c[51][l] * x0;
    const double w40 = c[52][l] * w38;
    const double w41 = w39 + w40;
    const double w42 = w41 * w41;
    const double w43 = c[54][l] * x0;
    const double w44 = c[51][l] * w38;
    const double w45 = w43 + w44;
    const double w46 = w45 * w45;
    const double w47 = w42 + w46;
    const double w48 = w47 * w47;
    const double w49 = w48 + c[53][l];
    const double w50 = sqrt(w49);
    const double w51 = sqrt(w50);
    const double w52 = 1.0 / w51;
    const double w53 = w41 * w52;
    const double w54 = w42 + c[58][l];
    const double w55 = sqrt(w54);
    const double w56 = 1.0 / w55;
    const double w57 = w45 * w56;
    const double w58 = w46 + w54;
    const double w59 = sqrt(w58);
    const double w60 = c[42][l] * x2;
    const double w61 = x1 + w60;
    const double w62 = c[69][l] * x0;
    const double w63 = c[70][l] * x2;
    const double w64 = w62 + w63;
    const double w65 = c[68][l] * w61;
    const double w66 = w64 + w65;
    const double w67 = w66 * w66;
    const double w68 = c[71][l] * x0;
    const double w69 = c[72][l] * x2;
    const double w70 = w68 + w69;
    const double w71 = c[69][l] * w61;
    const double w72 = w70 + w71;
    const double w73 = w72 * w72;
    const double w74 = w67 + w73;
    const double w75 = w74 * w74;
    const double w76 = w75 + c[53][l];
    const double w77 = sqrt(w76);
    const double w78 = sqrt(w77);
    const double w79 = 1.0 / w78;
    const double w80 = w66 * w79;
    const double w81 = w67 + c[58][l];
    const double w82 = sqrt(w81);
    const double w83 = 1.0 / w82;
    const double w84 = w72 * w83;
    const double w85 = w73 + w81;
    const double w86 = sqrt(w85);
    const double w87 = c[84][l] * x2;
    const double w88 = w62 + w87;
    const double w89 = c[71][l] * w61;
    const double w90 = w88 + w89;
    const double w91 = w90 * w90;
    const double w92 = c[68][l] * x0;
    const double w93 = c[85][l] * x2;
    const double w94 = w92 + w93;
    const double w95 = w94 + w71;
    const double w96 = w95 * w95;
    const double w97 = w91 + w96;
    const double w98 = w97 * w97;
    const double w99 = w98 + c[53][l];
    const double w100 = sqrt(w99);
    const double w101 = sqrt(w100);
    const double w102 = 1.0 / w101;
    const double w103 = w90 * w102;
    const double w104 = w91 + c[58][l];
    const double w105 = sqrt(w104);
    const double w106 = 1.0 / w105;
    const double w107 = w95 * w106;
    const double w108 = w96 + w104;
    const double w109 = sqrt(w108);
    const double w110 = w0 + c[96][l];
    const double w111 = c[95][l] * w32;
    const double w112 = w110 + w111;
    const double w113 = c[99][l] * x2;
    const double w114 = x1 + w113;
    const double w115 = w114 + w25;
    const double w116 = w115 * w115;
    const double w117 = w19 + w116;
    const double w118 = sqrt(w28);
    const double w119 = w118 * x2;
    const double w120 = x2 * x0;
    const double w121 = -w120;
    const double w122 = w121 + c[115][l];
    const double w123 = c[112][l] * w119;
    const double w124 = w122 + w123;
    const double w125 = c[122][l] * w119;
    const double w126 = w125 + c[131][l];
    const double w127 = x0 * w1;
    const double w128 = x1 * w2;
    const double w129 = -w128;
    const double w130 = w127 + w129;
    const double w131 = x0 * w2;
    const double w132 = x1 * w1;
    const double w133 = w131 + w132;
    w[0][l] = w19;
    w[1][l] = w20;
    w[2][l] = w26;
    w[3][l] = w28;
    w[4][l] = w30;
    w[5][l] = w34;
    w[6][l] = w36;
    w[9][l] = w52;
    w[10][l] = w53;
    w[12][l] = w57;
    w[17][l] = w59;
    w[22][l] = w79;
    w[23][l] = w80;
    w[25][l] = w84;
    w[30][l] = w86;
    w[34][l] = w102;
    w[35][l] = w103;
    w[37][l] = w107;
    w[42][l] = w109;
    w[46][l] = w112;
    w[48][l] = w115;
    w[49][l] = w117;
    w[52][l] = w124;
    w[54][l] = w126;
    WRITE(f, S3, w130);
    WRITE(f, S4, w133);
    WRITE(f, S5, x2);
}

INLINE void rate1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan2(0.0, w[1][l]);
    const double w1 = c[30][l] * w0;
    const double w2 = w1 + c[33][l];
    const double w3 = c[5][l] * w2;
    const double w4 = lane_min(c[28][l], w3);
    const double w5 = lane_max(c[29][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[34][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[34][l];
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
    const double w27 = c[36][l] * w26;
    const double w28 = w[5][l] + w27;
    const double w29 = c[43][l] * w26;
    const double w30 = w[6][l] + w29;
    const double w31 = c[42][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[48][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[18][l] * w34;
    const double w36 = w35 + c[17][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[50][l] * w38;
    const double w40 = w39 + 5e-06;
    const double w41 = lane_min(w40, w[10][l]);
    const double w42 = -w40;
    const double w43 = lane_max(w42, w41);
    const double w44 = c[55][l] * w38;
    const double w45 = w44 + 0.5;
    const double w46 = (-100000.0) * w43;
    const double w47 = w45 + w46;
    const double w48 = lane_max(0.0, w47);
    const double w49 = w48 * w48;
    const double w50 = w48 * w49;
    const double w51 = (-0.5) * w48;
    const double w52 = w51 + 1.0;
    const double w53 = w50 * w52;
    const double w54 = 100000.0 * w43;
    const double w55 = w45 + w54;
    const double w56 = lane_max(0.0, w55);
    const double w57 = w56 * w56;
    const double w58 = w56 * w57;
    const double w59 = (-0.5) * w56;
    const double w60 = w59 + 1.0;
    const double w61 = w58 * w60;
    const double w62 = 1e-05 * w53;
    const double w63 = w43 + w62;
    const double w64 = (-1e-05) * w61;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = -w66;
    const double w68 = w67 + 1.0;
    const double w69 = sqrt(w68);
    const double w70 = w69 + 5e-06;
    const double w71 = c[16][l] * w34;
    const double w72 = w71 + c[15][l];
    const double w73 = lane_max(0.0, w72);
    const double w74 = w73 * w[12][l];
    const double w75 = w74 * w38;
    const double w76 = c[49][l] * w75;
    const double w77 = lane_min(w76, c[56][l]);
    const double w78 = lane_max(c[57][l], w77);
    const double w79 = c[20][l] * w78;
    const double w80 = c[60][l] * w78;
    const double w81 = -w70;
    const double w82 = (-100000.0) * w69;
    const double w83 = w82 + 0.5;
    const double w84 = w34 * w65;
    const double w85 = w84 * w37;
    const double w86 = c[46][l] * w28;
    const double w87 = w86 + w30;
    const double w88 = c[64][l] * w87;
    const double w89 = lane_max(0.0, w88);
    const double w90 = c[9][l] * w89;
    const double w91 = w90 + c[8][l];
    const double w92 = lane_max(0.001, w91);
    const double w93 = 1.0 / w92;
    const double w94 = c[65][l] * w92;
    const double w95 = w94 + c[66][l];
    const double w96 = w95 * w93;
    const double w97 = c[67][l] * w96;
    const double w98 = w97 + 5e-06;
    const double w99 = lane_min(w98, w[23][l]);
    const double w100 = -w98;
    const double w101 = lane_max(w100, w99);
    const double w102 = c[73][l] * w96;
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
    const double w124 = w89 * w123;
    const double w125 = w124 * w92;
    const double w126 = w123 * w123;
    const double w127 = -w126;
    const double w128 = w127 + 1.0;
    const double w129 = sqrt(w128);
    const double w130 = w129 + 5e-06;
    const double w131 = c[7][l] * w89;
    const double w132 = w131 + c[6][l];
    const double w133 = lane_max(0.0, w132);
    const double w134 = w133 * w[25][l];
    const double w135 = w134 * w93;
    const double w136 = c[67][l] * w135;
    const double w137 = lane_min(w136, c[75][l]);
    const double w138 = lane_max(c[76][l], w137);
    const double w139 = c[11][l] * w138;
    const double w140 = c[77][l] * w138;
    const double w141 = -w130;
    const double w142 = (-100000.0) * w129;
    const double w143 = w142 + 0.5;
    const double w144 = c[74][l] * w125;
    const double w145 = c[81][l] * w92;
    const double w146 = w145 + c[82][l];
    const double w147 = w146 * w93;
    const double w148 = c[83][l] * w147;
    const double w149 = w148 + 5e-06;
    const double w150 = lane_min(w149, w[35][l]);
    const double w151 = -w149;
    const double w152 = lane_max(w151, w150);
    const double w153 = c[86][l] * w147;
    const double w154 = w153 + 0.5;
    const double w155 = (-100000.0) * w152;
    const double w156 = w154 + w155;
    const double w157 = lane_max(0.0, w156);
    const double w158 = w157 * w157;
    const double w159 = w157 * w158;
    const double w160 = (-0.5) * w157;
    const double w161 = w160 + 1.0;
    const double w162 = w159 * w161;
    const double w163 = 100000.0 * w152;
    const double w164 = w154 + w163;
    const double w165 = lane_max(0.0, w164);
    const double w166 = w165 * w165;
    const double w167 = w165 * w166;
    const double w168 = (-0.5) * w165;
    const double w169 = w168 + 1.0;
    const double w170 = w167 * w169;
    const double w171 = 1e-05 * w162;
    const double w172 = w152 + w171;
    const double w173 = (-1e-05) * w170;
    const double w174 = w172 + w173;
    const double w175 = w89 * w174;
    const double w176 = w175 * w92;
    const double w177 = w174 * w174;
    const double w178 = -w177;
    const double w179 = w178 + 1.0;
    const double w180 = sqrt(w179);
    const double w181 = w180 + 5e-06;
    const double w182 = w133 * w[37][l];
    const double w183 = w182 * w93;
    const double w184 = c[83][l] * w183;
    const double w185 = lane_min(w184, c[75][l]);
    const double w186 = lane_max(c[76][l], w185);
    const double w187 = c[11][l] * w186;
    const double w188 = c[77][l] * w186;
    const double w189 = -w181;
    const double w190 = (-100000.0) * w180;
    const double w191 = w190 + 0.5;
    const double w192 = c[87][l] * w176;
    const double w193 = c[93][l] * w85;
    const double w194 = w[46][l] + w193;
    const double w195 = lane_atan2(w[48][l], w[1][l]);
    const double w196 = w195 + c[100][l];
    const double w197 = c[26][l] * w196;
    const double w198 = lane_min(c[97][l], w197);
    const double w199 = lane_max(c[98][l], w198);
    const double w200 = (-5.0) * w199;
    const double w201 = w200 + c[101][l];
    const double w202 = lane_max(0.0, w201);
    const double w203 = w202 * w202;
    const double w204 = w202 * w203;
    const double w205 = (-0.5) * w202;
    const double w206 = w205 + 1.0;
    const double w207 = w204 * w206;
    const double w208 = 5.0 * w199;
    const double w209 = w208 + c[101][l];
    const double w210 = lane_max(0.0, w209);
    const double w211 = w210 * w210;
    const double w212 = w210 * w211;
    const double w213 = (-0.5) * w210;
    const double w214 = w213 + 1.0;
    const double w215 = w212 * w214;
    const double w216 = 0.2 * w207;
    const double w217 = w199 + w216;
    const double w218 = (-0.2) * w215;
    const double w219 = w217 + w218;
    const double w220 = w219 * w[49][l];
    const double w221 = lane_atan2(w[2][l], w[4][l]);
    const double w222 = c[23][l] * w221;
    const double w223 = w222 + c[106][l];
    const double w224 = w[3][l] * w223;
    const double w225 = c[79][l] * w125;
    const double w226 = c[108][l] * w85;
    const double w227 = c[111][l] * w176;
    const double w228 = w[52][l] + w227;
    const double w229 = c[110][l] * w220;
    const double w230 = w228 + w229;
    const double w231 = c[113][l] * w224;
    const double w232 = w230 + w231;
    const double w233 = c[25][l] * w221;
    const double w234 = w233 + c[117][l];
    const double w235 = w[3][l] * w234;
    const double w236 = c[129][l] * w176;
    const double w237 = w[54][l] + w236;
    const double w238 = c[124][l] * w220;
    const double w239 = w237 + w238;
    const double w240 = c[123][l] * w235;
    const double w241 = w239 + w240;
    w[7][l] = w34;
    w[8][l] = w37;
    w[11][l] = w70;
    w[13][l] = w79;
    w[14][l] = w80;
    w[18][l] = w81;
    w[19][l] = w83;
    w[20][l] = w89;
    w[21][l] = w92;
    w[24][l] = w130;
    w[26][l] = w139;
    w[27][l] = w140;
    w[31][l] = w141;
    w[32][l] = w143;
    w[33][l] = w144;
    w[36][l] = w181;
    w[38][l] = w187;
    w[39][l] = w188;
    w[43][l] = w189;
    w[44][l] = w191;
    w[45][l] = w192;
    w[47][l] = w194;
    w[50][l] = w225;
    w[51][l] = w226;
    w[53][l] = w232;
    w[55][l] = w241;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[13][l]);
    const double w1 = c[59][l] * w0;
    const double w2 = w[14][l] + w1;
    const double w3 = c[20][l] * w2;
    const double w4 = lane_atan(w[26][l]);
    const double w5 = c[78][l] * w4;
    const double w6 = w[27][l] + w5;
    const double w7 = c[11][l] * w6;
    const double w8 = lane_atan(w[38][l]);
    const double w9 = c[78][l] * w8;
    const double w10 = w[39][l] + w9;
    const double w11 = c[11][l] * w10;
    w[15][l] = w3;
    w[28][l] = w7;
    w[40][l] = w11;
}

INLINE void rate3(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[15][l]);
    const double w1 = c[21][l] * w0;
    const double w2 = lane_atan(w[28][l]);
    const double w3 = c[12][l] * w2;
    const double w4 = lane_atan(w[40][l]);
    const double w5 = c[12][l] * w4;
    w[16][l] = w1;
    w[29][l] = w3;
    w[41][l] = w5;
}

INLINE void rate4(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[16][l]);
    const double w1 = w0 * w[17][l];
    const double w2 = w1 * w[9][l];
    const double w3 = c[22][l] * w2;
    const double w4 = lane_min(w[11][l], w3);
    const double w5 = lane_max(w[18][l], w4);
    const double w6 = (-100000.0) * w5;
    const double w7 = w[19][l] + w6;
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 100000.0 * w5;
    const double w15 = w[19][l] + w14;
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 1e-05 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-1e-05) * w21;
    const double w25 = w23 + w24;
    const double w26 = w[7][l] * w25;
    const double w27 = w26 * w[8][l];
    const double w28 = lane_sin(w[29][l]);
    const double w29 = w28 * w[30][l];
    const double w30 = w29 * w[22][l];
    const double w31 = c[13][l] * w30;
    const double w32 = lane_min(w[24][l], w31);
    const double w33 = lane_max(w[31][l], w32);
    const double w34 = (-100000.0) * w33;
    const double w35 = w[32][l] + w34;
    const double w36 = lane_max(0.0, w35);
    const double w37 = w36 * w36;
    const double w38 = w36 * w37;
    const double w39 = (-0.5) * w36;
    const double w40 = w39 + 1.0;
    const double w41 = w38 * w40;
    const double w42 = 100000.0 * w33;
    const double w43 = w[32][l] + w42;
    const double w44 = lane_max(0.0, w43);
    const double w45 = w44 * w44;
    const double w46 = w44 * w45;
    const double w47 = (-0.5) * w44;
    const double w48 = w47 + 1.0;
    const double w49 = w46 * w48;
    const double w50 = 1e-05 * w41;
    const double w51 = w33 + w50;
    const double w52 = (-1e-05) * w49;
    const double w53 = w51 + w52;
    const double w54 = w[20][l] * w53;
    const double w55 = w54 * w[21][l];
    const double w56 = c[80][l] * w55;
    const double w57 = w[33][l] + w56;
    const double w58 = lane_sin(w[41][l]);
    const double w59 = w58 * w[42][l];
    const double w60 = w59 * w[34][l];
    const double w61 = c[13][l] * w60;
    const double w62 = lane_min(w[36][l], w61);
    const double w63 = lane_max(w[43][l], w62);
    const double w64 = (-100000.0) * w63;
    const double w65 = w[44][l] + w64;
    const double w66 = lane_max(0.0, w65);
    const double w67 = w66 * w66;
    const double w68 = w66 * w67;
    const double w69 = (-0.5) * w66;
    const double w70 = w69 + 1.0;
    const double w71 = w68 * w70;
    const double w72 = 100000.0 * w63;
    const double w73 = w[44][l] + w72;
    const double w74 = lane_max(0.0, w73);
    const double w75 = w74 * w74;
    const double w76 = w74 * w75;
    const double w77 = (-0.5) * w74;
    const double w78 = w77 + 1.0;
    const double w79 = w76 * w78;
    const double w80 = 1e-05 * w71;
    const double w81 = w63 + w80;
    const double w82 = (-1e-05) * w79;
    const double w83 = w81 + w82;
    const double w84 = w[20][l] * w83;
    const double w85 = w84 * w[21][l];
    const double w86 = c[88][l] * w85;
    const double w87 = w[45][l] + w86;
    const double w88 = c[92][l] * w27;
    const double w89 = w[47][l] + w88;
    const double w90 = c[94][l] * w57;
    const double w91 = w89 + w90;
    const double w92 = c[94][l] * w87;
    const double w93 = w91 + w92;
    const double w94 = c[74][l] * w55;
    const double w95 = w[50][l] + w94;
    const double w96 = c[109][l] * w27;
    const double w97 = w[51][l] + w96;
    const double w98 = c[114][l] * w85;
    const double w99 = w[53][l] + w98;
    const double w100 = c[94][l] * w95;
    const double w101 = w99 + w100;
    const double w102 = c[94][l] * w97;
    const double w103 = w101 + w102;
    const double w104 = c[125][l] * w57;
    const double w105 = w[55][l] + w104;
    const double w106 = c[130][l] * w85;
    const double w107 = w105 + w106;
    const double w108 = c[126][l] * w87;
    const double w109 = w107 + w108;
    const double w110 = c[127][l] * w95;
    const double w111 = w109 + w110;
    const double w112 = c[128][l] * w97;
    const double w113 = w111 + w112;
    WRITE(f, S0, w93);
    WRITE(f, S1, w103);
    WRITE(f, S2, w113);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[56];
    LANE_LOOP rate0(c, u, x, f, w, l);
    LANE_LOOP rate1(c, u, x, f, w, l);
    LANE_LOOP rate2(c, u, x, f, w, l);
    LANE_LOOP rate3(c, u, x, f, w, l);
    LANE_LOOP rate4(c, u, x, f, w, l);
}

#if DRIVER == 1
INLINE void turn0(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double x0 = MOVE(x, S0);
    const double x1 = MOVE(x, S1);
    const double x2 = MOVE(x, S2);
    const double x5 = MOVE(x, S5);
    const double e0 = MOVE(e, S0);
    const double e1 = MOVE(e, S1);
    const double e2 = MOVE(e, S2);
    const double e5 = MOVE(e, S5);
    const double m0 = MOVE(m, S0);
    const double m1 = MOVE(m, S1);
    const double m2 = MOVE(m, S2);
    const double m5 = MOVE(m, S5);
    const double w0 = x2 * x1;
    const double w1 = lane_cos(x5);
    const double w2 = lane_sin(x5);
    const double w3 = c[0][l] * w1;
    const double w4 = c[1][l] * w2;
    const double w5 = w3 + w4;
    const double w6 = -w5;
    const double w7 = x0 + w6;
    const double w8 = w7 * w7;
    const double w9 = w8 + 0.0001;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = w11 + c[32][l];
    const double w13 = w12 * w12;
    const double w14 = w13 + 1e-08;
    const double w15 = sqrt(w14);
    const double w16 = 0.5 * w11;
    const double w17 = w16 + c[31][l];
    const double w18 = 0.5 * w15;
    const double w19 = w17 + w18;
    const double w20 = sqrt(w19);
    const double w21 = w8 + 1e-08;
    const double w22 = c[1][l] * w1;
    const double w23 = c[38][l] * w2;
    const double w24 = w22 + w23;
    const double w25 = -w24;
    const double w26 = x1 + w25;
    const double w27 = w26 * w26;
    const double w28 = w21 + w27;
    const double w29 = w28 * w7;
    const double w30 = sqrt(w21);
    const double w31 = 1.0 / w30;
    const double w32 = w29 * w31;
    const double w33 = c[41][l] * w32;
    const double w34 = w33 + c[27][l];
    const double w35 = c[44][l] * w28;
    const double w36 = w35 + c[45][l];
    const double w37 = c[46][l] * x2;
    const double w38 = x1 + w37;
    const double w39 = c[51][l] * x0;
    const double w40 = c[52][l] * w38;
    const double w41 = w39 + w40;
    const double w42 = w41 * w41;
    const double w43 = c[54][l] * x0;
    const double w44 = c[51][l] * w38;
    const double w45 = w43 + w44;
    const double w46 = w45 * w45;
    const double w47 = w42 + w46;
    const double w48 = w47 * w47;
    const double w49 = w48 + c[53][l];
    const double w50 = sqrt(w49);
    const double w51 = sqrt(w50);
    const double w52 = 1.0 / w51;
    const double w53 = w41 * w52;
    const double w54 = w42 + c[58][l];
    const double w55 = sqrt(w54);
    const double w56 = 1.0 / w55;
    const double w57 = w45 * w56;
    const double w58 = w46 + w54;
    const double w59 = sqrt(w58);
    const double w60 = c[42][l] * x2;
    const double w61 = x1 + w60;
    const double w62 = c[69][l] * x0;
    const double w63 = c[70][l] * x2;
    const double w64 = w62 + w63;
    const double w65 = c[68][l] * w61;
    const double w66 = w64 + w65;
    const double w67 = w66 * w66;
    const double w68 = c[71][l] * x0;
    const double w69 = c[72][l] * x2;
    const double w70 = w68 + w69;
    const double w71 = c[69][l] * w61;
    const double w72 = w70 + w71;
    const double w73 = w72 * w72;
    const double w74 = w67 + w73;
    const double w75 = w74 * w74;
    const double w76 = w75 + c[53][l];
    const double w77 = sqrt(w76);
    const double w78 = sqrt(w77);
    const double w79 = 1.0 / w78;
    const double w80 = w66 * w79;
    const double w81 = w67 + c[58][l];
    const double w82 = sqrt(w81);
    const double w83 = 1.0 / w82;
    const double w84 = w72 * w83;
    const double w85 = w73 + w81;
    const double w86 = sqrt(w85);
    const double w87 = c[84][l] * x2;
    const double w88 = w62 + w87;
    const double w89 = c[71][l] * w61;
    const double w90 = w88 + w89;
    const double w91 = w90 * w90;
    const double w92 = c[68][l] * x0;
    const double w93 = c[85][l] * x2;
    const double w94 = w92 + w93;
    const double w95 = w94 + w71;
    const double w96 = w95 * w95;
    const double w97 = w91 + w96;
    const double w98 = w97 * w97;
    const double w99 = w98 + c[53][l];
    const double w100 = sqrt(w99);
    const double w101 = sqrt(w100);
    const double w102 = 1.0 / w101;
    const double w103 = w90 * w102;
    const double w104 = w91 + c[58][l];
    const double w105 = sqrt(w104);
    const double w106 = 1.0 / w105;
    const double w107 = w95 * w106;
    const double w108 = w96 + w104;
    const double w109 = sqrt(w108);
    const double w110 = w0 + c[96][l];
    const double w111 = c[95][l] * w32;
    const double w112 = w110 + w111;
    const double w113 = c[99][l] * x2;
    const double w114 = x1 + w113;
    const double w115 = w114 + w25;
    const double w116 = w115 * w115;
    const double w117 = w19 + w116;
    const double w118 = sqrt(w28);
    const double w119 = w118 * x2;
    const double w120 = x2 * x0;
    const double w121 = -w120;
    const double w122 = w121 + c[115][l];
    const double w123 = c[112][l] * w119;
    const double w124 = w122 + w123;
    const double w125 = c[122][l] * w119;
    const double w126 = w125 + c[131][l];
    const double w127 = x0 * w1;
    const double w128 = x1 * w2;
    const double w129 = -w128;
    const double w130 = w127 + w129;
    const double w131 = x0 * w2;
    const double w132 = x1 * w1;
    const double w133 = w131 + w132;
    const double w134 = x1 * e2;
    const double w135 = x2 * e1;
    const double w136 = w1 * e5;
    const double w137 = w2 * e5;
    const double w138 = c[1][l] * w136;
    const double w139 = c[38][l] * w137;
    const double w140 = w138 + w139;
    const double w141 = -w140;
    const double w142 = e0 + w141;
    const double w143 = w10 * w142;
    const double w144 = w7 * w142;
    const double w145 = 1.0 / w10;
    const double w146 = w144 * w145;
    const double w147 = w7 * w146;
    const double w148 = w143 + w147;
    const double w149 = w12 * w148;
    const double w150 = 1.0 / w15;
    const double w151 = w149 * w150;
    const double w152 = 0.5 * w148;
    const double w153 = 0.5 * w151;
    const double w154 = w152 + w153;
    const double w155 = c[0][l] * w136;
    const double w156 = c[1][l] * w137;
    const double w157 = w155 + w156;
    const double w158 = e1 + w157;
    const double w159 = w26 * w158;
    const double w160 = 2.0 * w144;
    const double w161 = 2.0 * w159;
    const double w162 = w160 + w161;
    const double w163 = c[44][l] * w162;
    const double w164 = w7 * w162;
    const double w165 = w28 * w142;
    const double w166 = c[40][l] * w164;
    const double w167 = c[40][l] * w165;
    const double w168 = w166 + w167;
    const double w169 = w168 * w31;
    const double w170 = w32 * w31;
    const double w171 = w144 * w31;
    const double w172 = w170 * w171;
    const double w173 = c[41][l] * w172;
    const double w174 = w169 + w173;
    const double w175 = c[46][l] * e2;
    const double w176 = e1 + w175;
    const double w177 = c[51][l] * e0;
    const double w178 = c[52][l] * w176;
    const double w179 = w177 + w178;
    const double w180 = w179 * w52;
    const double w181 = w53 * w52;
    const double w182 = w41 * w179;
    const double w183 = c[54][l] * e0;
    const double w184 = c[51][l] * w176;
    const double w185 = w183 + w184;
    const double w186 = w45 * w185;
    const double w187 = 2.0 * w182;
    const double w188 = 2.0 * w186;
    const double w189 = w187 + w188;
    const double w190 = w47 * w189;
    const double w191 = 1.0 / w50;
    const double w192 = w190 * w191;
    const double w193 = w192 * w52;
    const double w194 = w181 * w193;
    const double w195 = (-0.5) * w194;
    const double w196 = w180 + w195;
    const double w197 = w185 * w56;
    const double w198 = w57 * w56;
    const double w199 = w182 * w56;
    const double w200 = w198 * w199;
    const double w201 = -w200;
    const double w202 = w197 + w201;
    const double w203 = 1.0 / w59;
    const double w204 = w189 * w203;
    const double w205 = c[42][l] * e2;
    const double w206 = e1 + w205;
    const double w207 = c[69][l] * e0;
    const double w208 = c[70][l] * e2;
    const double w209 = w207 + w208;
    const double w210 = c[68][l] * w206;
    const double w211 = w209 + w210;
    const double w212 = w211 * w79;
    const double w213 = w80 * w79;
    const double w214 = w66 * w211;
    const double w215 = c[71][l] * e0;
    const double w216 = c[72][l] * e2;
    const double w217 = w215 + w216;
    const double w218 = c[69][l] * w206;
    const double w219 = w217 + w218;
    const double w220 = w72 * w219;
    const double w221 = 2.0 * w214;
    const double w222 = 2.0 * w220;
    const double w223 = w221 + w222;
    const double w224 = w74 * w223;
    const double w225 = 1.0 / w77;
    const double w226 = w224 * w225;
    const double w227 = w226 * w79;
    const double w228 = w213 * w227;
    const double w229 = (-0.5) * w228;
    const double w230 = w212 + w229;
    const double w231 = w219 * w83;
    const double w232 = w84 * w83;
    const double w233 = w214 * w83;
    const double w234 = w232 * w233;
    const double w235 = -w234;
    const double w236 = w231 + w235;
    const double w237 = 1.0 / w86;
    const double w238 = w223 * w237;
    const double w239 = c[84][l] * e2;
    const double w240 = w207 + w239;
    const double w241 = c[71][l] * w206;
    const double w242 = w240 + w241;
    const double w243 = w242 * w102;
    const double w244 = w103 * w102;
    const double w245 = w90 * w242;
    const double w246 = c[68][l] * e0;
    const double w247 = c[85][l] * e2;
    const double w248 = w246 + w247;
    const double w249 = w248 + w218;
    const double w250 = w95 * w249;
    const double w251 = 2.0 * w245;
    const double w252 = 2.0 * w250;
    const double w253 = w251 + w252;
    const double w254 = w97 * w253;
    const double w255 = 1.0 / w100;
    const double w256 = w254 * w255;
    const double w257 = w256 * w102;
    const double w258 = w244 * w257;
    const double w259 = (-0.5) * w258;
    const double w260 = w243 + w259;
    const double w261 = w249 * w106;
    const double w262 = w107 * w106;
    const double w263 = w245 * w106;
    const double w264 = w262 * w263;
    const double w265 = -w264;
    const double w266 = w261 + w265;
    const double w267 = 1.0 / w109;
    const double w268 = w253 * w267;
    const double w269 = c[89][l] * w164;
    const double w270 = c[89][l] * w165;
    const double w271 = w269 + w270;
    const double w272 = w271 * w31;
    const double w273 = w134 + w135;
    const double w274 = c[189][l] * w172;
    const double w275 = w273 + w274;
    const double w276 = c[94][l] * w272;
    const double w277 = w275 + w276;
    const double w278 = 1.0 / w117;
    const double w279 = w20 * w278;
    const double w280 = c[99][l] * e2;
    const double w281 = e1 + w280;
    const double w282 = w281 + w157;
    const double w283 = w279 * w282;
    const double w284 = w115 * w278;
    const double w285 = 1.0 / w20;
    const double w286 = w154 * w285;
    const double w287 = w284 * w286;
    const double w288 = (-0.5) * w287;
    const double w289 = w283 + w288;
    const double w290 = w115 * w282;
    const double w291 = 2.0 * w290;
    const double w292 = w154 + w291;
    const double w293 = 1.0 / w118;
    const double w294 = w162 * w293;
    const double w295 = x2 * w294;
    const double w296 = w118 * e2;
    const double w297 = c[194][l] * w295;
    const double w298 = c[104][l] * w296;
    const double w299 = w297 + w298;
    const double w300 = 1.0 / w28;
    const double w301 = w30 * w300;
    const double w302 = w301 * w158;
    const double w303 = w26 * w300;
    const double w304 = w303 * w171;
    const double w305 = -w304;
    const double w306 = w302 + w305;
    const double w307 = w28 * w306;
    const double w308 = x0 * e2;
    const double w309 = x2 * e0;
    const double w310 = -w308;
    const double w311 = -w309;
    const double w312 = w310 + w311;
    const double w313 = c[197][l] * w299;
    const double w314 = w312 + w313;
    const double w315 = c[198][l] * w307;
    const double w316 = w314 + w315;
    const double w317 = c[200][l] * w299;
    const double w318 = c[201][l] * w307;
    const double w319 = w317 + w318;
    const double w320 = w1 * e0;
    const double w321 = x0 * w137;
    const double w322 = w2 * e1;
    const double w323 = x1 * w136;
    const double w324 = -w321;
    const double w325 = w320 + w324;
    const double w326 = -w322;
    const double w327 = w325 + w326;
    const double w328 = -w323;
    const double w329 = w327 + w328;
    const double w330 = w2 * e0;
    const double w331 = x0 * w136;
    const double w332 = w1 * e1;
    const double w333 = x1 * w137;
    const double w334 = w330 + w331;
    const double w335 = w334 + w332;
    const double w336 = -w333;
    const double w337 = w335 + w336;
    const double w338 = x1 * m2;
    const double w339 = x2 * m1;
    const double w340 = w1 * m5;
    const double w341 = w2 * m5;
    const double w342 = c[1][l] * w340;
    const double w343 = c[38][l] * w341;
    const double w344 = w342 + w343;
    const double w345 = -w344;
    const double w346 = m0 + w345;
    const double w347 = w10 * w346;
    const double w348 = w7 * w346;
    const double w349 = w348 * w145;
    const double w350 = w7 * w349;
    const double w351 = w347 + w350;
    const double w352 = w12 * w351;
    const double w353 = w352 * w150;
    const double w354 = 0.5 * w351;
    const double w355 = 0.5 * w353;
    const double w356 = w354 + w355;
    const double w357 = c[0][l] * w340;
    const double w358 = c[1][l] * w341;
    const double w359 = w357 + w358;
    const double w360 = m1 + w359;
    const double w361 = w26 * w360;
    const double w362 = 2.0 * w348;
    const double w363 = 2.0 * w361;
    const double w364 = w362 + w363;
    const double w365 = c[44][l] * w364;
    const double w366 = w7 * w364;
    const double w367 = w28 * w346;
    const double w368 = c[40][l] * w366;
    const double w369 = c[40][l] * w367;
    const double w370 = w368 + w369;
    const double w371 = w370 * w31;
    const double w372 = w348 * w31;
    const double w373 = w170 * w372;
    const double w374 = c[41][l] * w373;
    const double w375 = w371 + w374;
    const double w376 = c[46][l] * m2;
    const double w377 = m1 + w376;
    const double w378 = c[51][l] * m0;
    const double w379 = c[52][l] * w377;
    const double w380 = w378 + w379;
    const double w381 = w380 * w52;
    const double w382 = w41 * w380;
    const double w383 = c[54][l] * m0;
    const double w384 = c[51][l] * w377;
    const double w385 = w383 + w384;
    const double w386 = w45 * w385;
    const double w387 = 2.0 * w382;
    const double w388 = 2.0 * w386;
    const double w389 = w387 + w388;
    const double w390 = w47 * w389;
    const double w391 = w390 * w191;
    const double w392 = w391 * w52;
    const double w393 = w181 * w392;
    const double w394 = (-0.5) * w393;
    const double w395 = w381 + w394;
    const double w396 = w385 * w56;
    const double w397 = w382 * w56;
    const double w398 = w198 * w397;
    const double w399 = -w398;
    const double w400 = w396 + w399;
    const double w401 = w389 * w203;
    const double w402 = c[42][l] * m2;
    const double w403 = m1 + w402;
    const double w404 = c[69][l] * m0;
    const double w405 = c[70][l] * m2;
    const double w406 = w404 + w405;
    const double w407 = c[68][l] * w403;
    const double w408 = w406 + w407;
    const double w409 = w408 * w79;
    const double w410 = w66 * w408;
    const double w411 = c[71][l] * m0;
    const double w412 = c[72][l] * m2;
    const double w413 = w411 + w412;
    const double w414 = c[69][l] * w403;
    const double w415 = w413 + w414;
    const double w416 = w72 * w415;
    const double w417 = 2.0 * w410;
    const double w418 = 2.0 * w416;
    const double w419 = w417 + w418;
    const double w420 = w74 * w419;
    const double w421 = w420 * w225;
    const double w422 = w421 * w79;
    const double w423 = w213 * w422;
    const double w424 = (-0.5) * w423;
    const double w425 = w409 + w424;
    const double w426 = w415 * w83;
    const double w427 = w410 * w83;
    const double w428 = w232 * w427;
    const double w429 = -w428;
    const double w430 = w426 + w429;
    const double w431 = w419 * w237;
    const double w432 = c[84][l] * m2;
    const double w433 = w404 + w432;
    const double w434 = c[71][l] * w403;
    const double w435 = w433 + w434;
    const double w436 = w435 * w102;
    const double w437 = w90 * w435;
    const double w438 = c[68][l] * m0;
    const double w439 = c[85][l] * m2;
    const double w440 = w438 + w439;
    const double w441 = w440 + w414;
    const double w442 = w95 * w441;
    const double w443 = 2.0 * w437;
    const double w444 = 2.0 * w442;
    const double w445 = w443 + w444;
    const double w446 = w97 * w445;
    const double w447 = w446 * w255;
    const double w448 = w447 * w102;
    const double w449 = w244 * w448;
    const double w450 = (-0.5) * w449;
    const double w451 = w436 + w450;
    const double w452 = w441 * w106;
    const double w453 = w437 * w106;
    const double w454 = w262 * w453;
    const double w455 = -w454;
    const double w456 = w452 + w455;
    const double w457 = w445 * w267;
    const double w458 = c[89][l] * w366;
    const double w459 = c[89][l] * w367;
    const double w460 = w458 + w459;
    const double w461 = w460 * w31;
    const double w462 = w338 + w339;
    const double w463 = c[189][l] * w373;
    const double w464 = w462 + w463;
    const double w465 = c[94][l] * w461;
    const double w466 = w464 + w465;
    const double w467 = c[99][l] * m2;
    const double w468 = m1 + w467;
    const double w469 = w468 + w359;
    const double w470 = w279 * w469;
    const double w471 = w356 * w285;
    const double w472 = w284 * w471;
    const double w473 = (-0.5) * w472;
    const double w474 = w470 + w473;
    const double w475 = w115 * w469;
    const double w476 = 2.0 * w475;
    const double w477 = w356 + w476;
    const double w478 = w364 * w293;
    const double w479 = x2 * w478;
    const double w480 = w118 * m2;
    const double w481 = c[194][l] * w479;
    const double w482 = c[104][l] * w480;
    const double w483 = w481 + w482;
    const double w484 = w301 * w360;
    const double w485 = w303 * w372;
    const double w486 = -w485;
    const double w487 = w484 + w486;
    const double w488 = w28 * w487;
    const double w489 = x0 * m2;
    const double w490 = x2 * m0;
    const double w491 = -w489;
    const double w492 = -w490;
    const double w493 = w491 + w492;
    const double w494 = c[197][l] * w483;
    const double w495 = w493 + w494;
    const double w496 = c[198][l] * w488;
    const double w497 = w495 + w496;
    const double w498 = c[200][l] * w483;
    const double w499 = c[201][l] * w488;
    const double w500 = w498 + w499;
    const double w501 = w1 * m0;
    const double w502 = x0 * w341;
    const double w503 = w2 * m1;
    const double w504 = x1 * w340;
    const double w505 = -w502;
    const double w506 = w501 + w505;
    const double w507 = -w503;
    const double w508 = w506 + w507;
    const double w509 = -w504;
    const double w510 = w508 + w509;
    const double w511 = w2 * m0;
    const double w512 = x0 * w340;
    const double w513 = w1 * m1;
    const double w514 = x1 * w341;
    const double w515 = w511 + w512;
    const double w516 = w515 + w513;
    const double w517 = -w514;
    const double w518 = w516 + w517;
    w[0][l] = w19;
    w[1][l] = w20;
    w[2][l] = w26;
    w[3][l] = w28;
    w[4][l] = w30;
    w[5][l] = w34;
    w[6][l] = w36;
    w[9][l] = w52;
    w[10][l] = w53;
    w[12][l] = w57;
    w[17][l] = w59;
    w[22][l] = w79;
    w[23][l] = w80;
    w[25][l] = w84;
    w[30][l] = w86;
    w[34][l] = w102;
    w[35][l] = w103;
    w[37][l] = w107;
    w[42][l] = w109;
    w[46][l] = w112;
    w[48][l] = w115;
    w[49][l] = w117;
    w[52][l] = w124;
    w[54][l] = w126;
    w[56][l] = w154;
    w[57][l] = w162;
    w[58][l] = w163;
    w[59][l] = w174;
    w[62][l] = w193;
    w[63][l] = w196;
    w[65][l] = w202;
    w[68][l] = w204;
    w[73][l] = w227;
    w[74][l] = w230;
    w[76][l] = w236;
    w[79][l] = w238;
    w[83][l] = w257;
    w[84][l] = w260;
    w[86][l] = w266;
    w[89][l] = w268;
    w[93][l] = w277;
    w[95][l] = w289;
    w[96][l] = w292;
    w[99][l] = w316;
    w[101][l] = w319;
    w[103][l] = w356;
    w[104][l] = w364;
    w[105][l] = w365;
    w[106][l] = w375;
    w[109][l] = w392;
    w[110][l] = w395;
    w[112][l] = w400;
    w[115][l] = w401;
    w[120][l] = w422;
    w[121][l] = w425;
    w[123][l] = w430;
    w[126][l] = w431;
    w[130][l] = w448;
    w[131][l] = w451;
    w[133][l] = w456;
    w[136][l] = w457;
    w[140][l] = w466;
    w[142][l] = w474;
    w[143][l] = w477;
    w[146][l] = w497;
    w[148][l] = w500;
    WRITE(f, S3, w130);
    WRITE(f, S4, w133);
    WRITE(f, S5, x2);
    WRITE(r, S3, w329);
    WRITE(r, S4, w337);
    WRITE(r, S5, e2);
    WRITE_MOVING(g, S3, w510);
    WRITE_MOVING(g, S4, w518);
    WRITE_MOVING(g, S5, m2);
}

INLINE void turn1(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan2(0.0, w[1][l]);
    const double w1 = c[30][l] * w0;
    const double w2 = w1 + c[33][l];
    const double w3 = c[5][l] * w2;
    const double w4 = lane_min(c[28][l], w3);
    const double w5 = lane_max(c[29][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[34][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[34][l];
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
    const double w27 = c[36][l] * w26;
    const double w28 = w[5][l] + w27;
    const double w29 = c[43][l] * w26;
    const double w30 = w[6][l] + w29;
    const double w31 = c[42][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[48][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[18][l] * w34;
    const double w36 = w35 + c[17][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[50][l] * w38;
    const double w40 = w39 + 5e-06;
    const double w41 = lane_min(w40, w[10][l]);
    const double w42 = -w40;
    const double w43 = lane_max(w42, w41);
    const double w44 = c[55][l] * w38;
    const double w45 = w44 + 0.5;
    const double w46 = (-100000.0) * w43;
    const double w47 = w45 + w46;
    const double w48 = lane_max(0.0, w47);
    const double w49 = w48 * w48;
    const double w50 = w48 * w49;
    const double w51 = (-0.5) * w48;
    const double w52 = w51 + 1.0;
    const double w53 = w50 * w52;
    const double w54 = 100000.0 * w43;
    const double w55 = w45 + w54;
    const double w56 = lane_max(0.0, w55);
    const double w57 = w56 * w56;
    const double w58 = w56 * w57;
    const double w59 = (-0.5) * w56;
    const double w60 = w59 + 1.0;
    const double w61 = w58 * w60;
    const double w62 = 1e-05 * w53;
    const double w63 = w43 + w62;
    const double w64 = (-1e-05) * w61;
    const double w65 = w63 + w64;
    const double w66 = w65 * w65;
    const double w67 = -w66;
    const double w68 = w67 + 1.0;
    const double w69 = sqrt(w68);
    const double w70 = w69 + 5e-06;
    const double w71 = c[16][l] * w34;
    const double w72 = w71 + c[15][l];
    const double w73 = lane_max(0.0, w72);
    const double w74 = w73 * w[12][l];
    const double w75 = w74 * w38;
    const double w76 = c[49][l] * w75;
    const double w77 = lane_min(w76, c[56][l]);
    const double w78 = lane_max(c[57][l], w77);
    const double w79 = c[20][l] * w78;
    const double w80 = c[60][l] * w78;
    const double w81 = -w70;
    const double w82 = (-100000.0) * w69;
    const double w83 = w82 + 0.5;
    const double w84 = w34 * w65;
    const double w85 = w84 * w37;
    const double w86 = c[46][l] * w28;
    const double w87 = w86 + w30;
    const double w88 = c[64][l] * w87;
    const double w89 = lane_max(0.0, w88);
    const double w90 = c[9][l] * w89;
    const double w91 = w90 + c[8][l];
    const double w92 = lane_max(0.001, w91);
    const double w93 = 1.0 / w92;
    const double w94 = c[65][l] * w92;
    const double w95 = w94 + c[66][l];
    const double w96 = w95 * w93;
    const double w97 = c[67][l] * w96;
    const double w98 = w97 + 5e-06;
    const double w99 = lane_min(w98, w[23][l]);
    const double w100 = -w98;
    const double w101 = lane_max(w100, w99);
    const double w102 = c[73][l] * w96;
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
    const double w124 = w89 * w123;
    const double w125 = w124 * w92;
    const double w126 = w123 * w123;
    const double w127 = -w126;
    const double w128 = w127 + 1.0;
    const double w129 = sqrt(w128);
    const double w130 = w129 + 5e-06;
    const double w131 = c[7][l] * w89;
    const double w132 = w131 + c[6][l];
    const double w133 = lane_max(0.0, w132);
    const double w134 = w133 * w[25][l];
    const double w135 = w134 * w93;
    const double w136 = c[67][l] * w135;
    const double w137 = lane_min(w136, c[75][l]);
    const double w138 = lane_max(c[76][l], w137);
    const double w139 = c[11][l] * w138;
    const double w140 = c[77][l] * w138;
    const double w141 = -w130;
    const double w142 = (-100000.0) * w129;
    const double w143 = w142 + 0.5;
    const double w144 = c[74][l] * w125;
    const double w145 = c[81][l] * w92;
    const double w146 = w145 + c[82][l];
    const double w147 = w146 * w93;
    const double w148 = c[83][l] * w147;
    const double w149 = w148 + 5e-06;
    const double w150 = lane_min(w149, w[35][l]);
    const double w151 = -w149;
    const double w152 = lane_max(w151, w150);
    const double w153 = c[86][l] * w147;
    const double w154 = w153 + 0.5;
    const double w155 = (-100000.0) * w152;
    const double w156 = w154 + w155;
    const double w157 = lane_max(0.0, w156);
    const double w158 = w157 * w157;
    const double w159 = w157 * w158;
    const double w160 = (-0.5) * w157;
    const double w161 = w160 + 1.0;
    const double w162 = w159 * w161;
    const double w163 = 100000.0 * w152;
    const double w164 = w154 + w163;
    const double w165 = lane_max(0.0, w164);
    const double w166 = w165 * w165;
    const double w167 = w165 * w166;
    const double w168 = (-0.5) * w165;
    const double w169 = w168 + 1.0;
    const double w170 = w167 * w169;
    const double w171 = 1e-05 * w162;
    const double w172 = w152 + w171;
    const double w173 = (-1e-05) * w170;
    const double w174 = w172 + w173;
    const double w175 = w89 * w174;
    const double w176 = w175 * w92;
    const double w177 = w174 * w174;
    const double w178 = -w177;
    const double w179 = w178 + 1.0;
    const double w180 = sqrt(w179);
    const double w181 = w180 + 5e-06;
    const double w182 = w133 * w[37][l];
    const double w183 = w182 * w93;
    const double w184 = c[83][l] * w183;
    const double w185 = lane_min(w184, c[75][l]);
    const double w186 = lane_max(c[76][l], w185);
    const double w187 = c[11][l] * w186;
    const double w188 = c[77][l] * w186;
    const double w189 = -w181;
    const double w190 = (-100000.0) * w180;
    const double w191 = w190 + 0.5;
    const double w192 = c[87][l] * w176;
    const double w193 = c[93][l] * w85;
    const double w194 = w[46][l] + w193;
    const double w195 = lane_atan2(w[48][l], w[1][l]);
    const double w196 = w195 + c[100][l];
    const double w197 = c[26][l] * w196;
    const double w198 = lane_min(c[97][l], w197);
    const double w199 = lane_max(c[98][l], w198);
    const double w200 = (-5.0) * w199;
    const double w201 = w200 + c[101][l];
    const double w202 = lane_max(0.0, w201);
    const double w203 = w202 * w202;
    const double w204 = w202 * w203;
    const double w205 = (-0.5) * w202;
    const double w206 = w205 + 1.0;
    const double w207 = w204 * w206;
    const double w208 = 5.0 * w199;
    const double w209 = w208 + c[101][l];
    const double w210 = lane_max(0.0, w209);
    const double w211 = w210 * w210;
    const double w212 = w210 * w211;
    const double w213 = (-0.5) * w210;
    const double w214 = w213 + 1.0;
    const double w215 = w212 * w214;
    const double w216 = 0.2 * w207;
    const double w217 = w199 + w216;
    const double w218 = (-0.2) * w215;
    const double w219 = w217 + w218;
    const double w220 = w219 * w[49][l];
    const double w221 = lane_atan2(w[2][l], w[4][l]);
    const double w222 = c[23][l] * w221;
    const double w223 = w222 + c[106][l];
    const double w224 = w[3][l] * w223;
    const double w225 = c[79][l] * w125;
    const double w226 = c[108][l] * w85;
    const double w227 = c[111][l] * w176;
    const double w228 = w[52][l] + w227;
    const double w229 = c[110][l] * w220;
    const double w230 = w228 + w229;
    const double w231 = c[113][l] * w224;
    const double w232 = w230 + w231;
    const double w233 = c[25][l] * w221;
    const double w234 = w233 + c[117][l];
    const double w235 = w[3][l] * w234;
    const double w236 = c[129][l] * w176;
    const double w237 = w[54][l] + w236;
    const double w238 = c[124][l] * w220;
    const double w239 = w237 + w238;
    const double w240 = c[123][l] * w235;
    const double w241 = w239 + w240;
    const double w242 = 0.0 <= w33 ? 1.0 : 0.0;
    const double w243 = w33 <= 0.0 ? 1.0 : 0.0;
    const double w244 = w242 + w243;
    const double w245 = 1.0 / w244;
    const double w246 = w242 * w245;
    const double w247 = w25 * w[56][l];
    const double w248 = c[43][l] * w247;
    const double w249 = w[58][l] + w248;
    const double w250 = c[35][l] * w247;
    const double w251 = w[59][l] + w250;
    const double w252 = c[121][l] * w251;
    const double w253 = w249 + w252;
    const double w254 = w246 * w253;
    const double w255 = w41 <= w42 ? 1.0 : 0.0;
    const double w256 = w42 <= w41 ? 1.0 : 0.0;
    const double w257 = w255 + w256;
    const double w258 = 1.0 / w257;
    const double w259 = w255 * w258;
    const double w260 = w38 * w38;
    const double w261 = 0.001 <= w36 ? 1.0 : 0.0;
    const double w262 = w36 <= 0.001 ? 1.0 : 0.0;
    const double w263 = w261 + w262;
    const double w264 = 1.0 / w263;
    const double w265 = w261 * w264;
    const double w266 = w265 * w254;
    const double w267 = w260 * w266;
    const double w268 = w259 * w267;
    const double w269 = w256 * w258;
    const double w270 = w[10][l] <= w40 ? 1.0 : 0.0;
    const double w271 = w40 <= w[10][l] ? 1.0 : 0.0;
    const double w272 = w270 + w271;
    const double w273 = 1.0 / w272;
    const double w274 = w270 * w273;
    const double w275 = w274 * w[63][l];
    const double w276 = w271 * w273;
    const double w277 = w276 * w267;
    const double w278 = c[164][l] * w277;
    const double w279 = w275 + w278;
    const double w280 = w269 * w279;
    const double w281 = c[163][l] * w268;
    const double w282 = w281 + w280;
    const double w283 = 0.0 <= w47 ? 1.0 : 0.0;
    const double w284 = w47 <= 0.0 ? 1.0 : 0.0;
    const double w285 = w283 + w284;
    const double w286 = 1.0 / w285;
    const double w287 = w283 * w286;
    const double w288 = c[165][l] * w267;
    const double w289 = 100000.0 * w282;
    const double w290 = w288 + w289;
    const double w291 = w287 * w290;
    const double w292 = w50 * w291;
    const double w293 = w49 * w291;
    const double w294 = w48 * w291;
    const double w295 = w48 * w294;
    const double w296 = 2.0 * w295;
    const double w297 = w293 + w296;
    const double w298 = w52 * w297;
    const double w299 = 0.0 <= w55 ? 1.0 : 0.0;
    const double w300 = w55 <= 0.0 ? 1.0 : 0.0;
    const double w301 = w299 + w300;
    const double w302 = 1.0 / w301;
    const double w303 = w299 * w302;
    const double w304 = c[166][l] * w267;
    const double w305 = w304 + w289;
    const double w306 = w303 * w305;
    const double w307 = w57 * w306;
    const double w308 = w56 * w306;
    const double w309 = w56 * w308;
    const double w310 = 2.0 * w309;
    const double w311 = w307 + w310;
    const double w312 = w60 * w311;
    const double w313 = w58 * w306;
    const double w314 = 5e-06 * w292;
    const double w315 = w282 + w314;
    const double w316 = (-1e-05) * w298;
    const double w317 = w315 + w316;
    const double w318 = (-1e-05) * w312;
    const double w319 = w317 + w318;
    const double w320 = 5e-06 * w313;
    const double w321 = w319 + w320;
    const double w322 = w65 * w321;
    const double w323 = 1.0 / w69;
    const double w324 = w322 * w323;
    const double w325 = c[57][l] <= w77 ? 1.0 : 0.0;
    const double w326 = w77 <= c[57][l] ? 1.0 : 0.0;
    const double w327 = w325 + w326;
    const double w328 = 1.0 / w327;
    const double w329 = w325 * w328;
    const double w330 = w76 <= c[56][l] ? 1.0 : 0.0;
    const double w331 = c[56][l] <= w76 ? 1.0 : 0.0;
    const double w332 = w330 + w331;
    const double w333 = 1.0 / w332;
    const double w334 = w330 * w333;
    const double w335 = 0.0 <= w72 ? 1.0 : 0.0;
    const double w336 = w72 <= 0.0 ? 1.0 : 0.0;
    const double w337 = w335 + w336;
    const double w338 = 1.0 / w337;
    const double w339 = w335 * w338;
    const double w340 = w339 * w254;
    const double w341 = w[12][l] * w340;
    const double w342 = w73 * w[65][l];
    const double w343 = c[167][l] * w341;
    const double w344 = w343 + w342;
    const double w345 = w344 * w38;
    const double w346 = w75 * w38;
    const double w347 = w346 * w266;
    const double w348 = c[49][l] * w345;
    const double w349 = c[168][l] * w347;
    const double w350 = w348 + w349;
    const double w351 = w334 * w350;
    const double w352 = w329 * w351;
    const double w353 = w78 * w78;
    const double w354 = c[169][l] * w353;
    const double w355 = w354 + 1.0;
    const double w356 = 1.0 / w355;
    const double w357 = w352 * w356;
    const double w358 = c[60][l] * w352;
    const double w359 = c[170][l] * w357;
    const double w360 = w358 + w359;
    const double w361 = (-100000.0) * w324;
    const double w362 = 100000.0 * w324;
    const double w363 = w65 * w254;
    const double w364 = w34 * w321;
    const double w365 = c[48][l] * w363;
    const double w366 = w365 + w364;
    const double w367 = w37 * w366;
    const double w368 = w84 * w266;
    const double w369 = c[19][l] * w367;
    const double w370 = c[162][l] * w368;
    const double w371 = w369 + w370;
    const double w372 = w100 <= w99 ? 1.0 : 0.0;
    const double w373 = w99 <= w100 ? 1.0 : 0.0;
    const double w374 = w372 + w373;
    const double w375 = 1.0 / w374;
    const double w376 = w372 * w375;
    const double w377 = w98 <= w[23][l] ? 1.0 : 0.0;
    const double w378 = w[23][l] <= w98 ? 1.0 : 0.0;
    const double w379 = w377 + w378;
    const double w380 = 1.0 / w379;
    const double w381 = w377 * w380;
    const double w382 = w96 * w93;
    const double w383 = 0.001 <= w91 ? 1.0 : 0.0;
    const double w384 = w91 <= 0.001 ? 1.0 : 0.0;
    const double w385 = w383 + w384;
    const double w386 = 1.0 / w385;
    const double w387 = w383 * w386;
    const double w388 = 0.0 <= w88 ? 1.0 : 0.0;
    const double w389 = w88 <= 0.0 ? 1.0 : 0.0;
    const double w390 = w388 + w389;
    const double w391 = 1.0 / w390;
    const double w392 = w388 * w391;
    const double w393 = c[47][l] * w251;
    const double w394 = w249 + w393;
    const double w395 = w392 * w394;
    const double w396 = w387 * w395;
    const double w397 = w382 * w396;
    const double w398 = w396 * w93;
    const double w399 = c[174][l] * w397;
    const double w400 = c[175][l] * w398;
    const double w401 = w399 + w400;
    const double w402 = w381 * w401;
    const double w403 = w378 * w380;
    const double w404 = w403 * w[74][l];
    const double w405 = w402 + w404;
    const double w406 = w376 * w405;
    const double w407 = w373 * w375;
    const double w408 = w407 * w401;
    const double w409 = -w408;
    const double w410 = w406 + w409;
    const double w411 = 0.0 <= w105 ? 1.0 : 0.0;
    const double w412 = w105 <= 0.0 ? 1.0 : 0.0;
    const double w413 = w411 + w412;
    const double w414 = 1.0 / w413;
    const double w415 = w411 * w414;
    const double w416 = (-100000.0) * w401;
    const double w417 = (-100000.0) * w410;
    const double w418 = w416 + w417;
    const double w419 = w415 * w418;
    const double w420 = w107 * w419;
    const double w421 = w106 * w419;
    const double w422 = w106 * w421;
    const double w423 = 2.0 * w422;
    const double w424 = w420 + w423;
    const double w425 = w110 * w424;
    const double w426 = w108 * w419;
    const double w427 = 0.0 <= w113 ? 1.0 : 0.0;
    const double w428 = w113 <= 0.0 ? 1.0 : 0.0;
    const double w429 = w427 + w428;
    const double w430 = 1.0 / w429;
    const double w431 = w427 * w430;
    const double w432 = 100000.0 * w410;
    const double w433 = w416 + w432;
    const double w434 = w431 * w433;
    const double w435 = w115 * w434;
    const double w436 = w114 * w434;
    const double w437 = w114 * w436;
    const double w438 = 2.0 * w437;
    const double w439 = w435 + w438;
    const double w440 = w118 * w439;
    const double w441 = w116 * w434;
    const double w442 = 1e-05 * w425;
    const double w443 = w410 + w442;
    const double w444 = (-5e-06) * w426;
    const double w445 = w443 + w444;
    const double w446 = (-1e-05) * w440;
    const double w447 = w445 + w446;
    const double w448 = 5e-06 * w441;
    const double w449 = w447 + w448;
    const double w450 = w89 * w449;
    const double w451 = w123 * w395;
    const double w452 = c[64][l] * w451;
    const double w453 = w450 + w452;
    const double w454 = w92 * w453;
    const double w455 = w124 * w396;
    const double w456 = c[10][l] * w454;
    const double w457 = c[176][l] * w455;
    const double w458 = w456 + w457;
    const double w459 = w123 * w449;
    const double w460 = 1.0 / w129;
    const double w461 = w459 * w460;
    const double w462 = c[76][l] <= w137 ? 1.0 : 0.0;
    const double w463 = w137 <= c[76][l] ? 1.0 : 0.0;
    const double w464 = w462 + w463;
    const double w465 = 1.0 / w464;
    const double w466 = w462 * w465;
    const double w467 = w136 <= c[75][l] ? 1.0 : 0.0;
    const double w468 = c[75][l] <= w136 ? 1.0 : 0.0;
    const double w469 = w467 + w468;
    const double w470 = 1.0 / w469;
    const double w471 = w467 * w470;
    const double w472 = w133 * w[76][l];
    const double w473 = 0.0 <= w132 ? 1.0 : 0.0;
    const double w474 = w132 <= 0.0 ? 1.0 : 0.0;
    const double w475 = w473 + w474;
    const double w476 = 1.0 / w475;
    const double w477 = w473 * w476;
    const double w478 = w477 * w395;
    const double w479 = w[25][l] * w478;
    const double w480 = c[178][l] * w479;
    const double w481 = w472 + w480;
    const double w482 = w481 * w93;
    const double w483 = w135 * w93;
    const double w484 = w483 * w396;
    const double w485 = c[67][l] * w482;
    const double w486 = c[174][l] * w484;
    const double w487 = w485 + w486;
    const double w488 = w471 * w487;
    const double w489 = w466 * w488;
    const double w490 = w138 * w138;
    const double w491 = c[179][l] * w490;
    const double w492 = w491 + 1.0;
    const double w493 = 1.0 / w492;
    const double w494 = w489 * w493;
    const double w495 = c[77][l] * w489;
    const double w496 = c[180][l] * w494;
    const double w497 = w495 + w496;
    const double w498 = (-100000.0) * w461;
    const double w499 = 100000.0 * w461;
    const double w500 = c[69][l] * w458;
    const double w501 = w151 <= w150 ? 1.0 : 0.0;
    const double w502 = w150 <= w151 ? 1.0 : 0.0;
    const double w503 = w501 + w502;
    const double w504 = 1.0 / w503;
    const double w505 = w501 * w504;
    const double w506 = w149 <= w[35][l] ? 1.0 : 0.0;
    const double w507 = w[35][l] <= w149 ? 1.0 : 0.0;
    const double w508 = w506 + w507;
    const double w509 = 1.0 / w508;
    const double w510 = w506 * w509;
    const double w511 = w147 * w93;
    const double w512 = w511 * w396;
    const double w513 = c[185][l] * w398;
    const double w514 = c[184][l] * w512;
    const double w515 = w513 + w514;
    const double w516 = w510 * w515;
    const double w517 = w507 * w509;
    const double w518 = w517 * w[84][l];
    const double w519 = w516 + w518;
    const double w520 = w505 * w519;
    const double w521 = w502 * w504;
    const double w522 = w521 * w515;
    const double w523 = -w522;
    const double w524 = w520 + w523;
    const double w525 = 0.0 <= w156 ? 1.0 : 0.0;
    const double w526 = w156 <= 0.0 ? 1.0 : 0.0;
    const double w527 = w525 + w526;
    const double w528 = 1.0 / w527;
    const double w529 = w525 * w528;
    const double w530 = (-100000.0) * w515;
    const double w531 = (-100000.0) * w524;
    const double w532 = w530 + w531;
    const double w533 = w529 * w532;
    const double w534 = w158 * w533;
    const double w535 = w157 * w533;
    const double w536 = w157 * w535;
    const double w537 = 2.0 * w536;
    const double w538 = w534 + w537;
    const double w539 = w161 * w538;
    const double w540 = w159 * w533;
    const double w541 = 0.0 <= w164 ? 1.0 : 0.0;
    const double w542 = w164 <= 0.0 ? 1.0 : 0.0;
    const double w543 = w541 + w542;
    const double w544 = 1.0 / w543;
    const double w545 = w541 * w544;
    const double w546 = 100000.0 * w524;
    const double w547 = w530 + w546;
    const double w548 = w545 * w547;
    const double w549 = w166 * w548;
    const double w550 = w165 * w548;
    const double w551 = w165 * w550;
    const double w552 = 2.0 * w551;
    const double w553 = w549 + w552;
    const double w554 = w169 * w553;
    const double w555 = w167 * w548;
    const double w556 = 1e-05 * w539;
    const double w557 = w524 + w556;
    const double w558 = (-5e-06) * w540;
    const double w559 = w557 + w558;
    const double w560 = (-1e-05) * w554;
    const double w561 = w559 + w560;
    const double w562 = 5e-06 * w555;
    const double w563 = w561 + w562;
    const double w564 = w89 * w563;
    const double w565 = w174 * w395;
    const double w566 = c[64][l] * w565;
    const double w567 = w564 + w566;
    const double w568 = w92 * w567;
    const double w569 = w175 * w396;
    const double w570 = c[14][l] * w568;
    const double w571 = c[186][l] * w569;
    const double w572 = w570 + w571;
    const double w573 = w174 * w563;
    const double w574 = 1.0 / w180;
    const double w575 = w573 * w574;
    const double w576 = c[76][l] <= w185 ? 1.0 : 0.0;
    const double w577 = w185 <= c[76][l] ? 1.0 : 0.0;
    const double w578 = w576 + w577;
    const double w579 = 1.0 / w578;
    const double w580 = w576 * w579;
    const double w581 = w184 <= c[75][l] ? 1.0 : 0.0;
    const double w582 = c[75][l] <= w184 ? 1.0 : 0.0;
    const double w583 = w581 + w582;
    const double w584 = 1.0 / w583;
    const double w585 = w581 * w584;
    const double w586 = w133 * w[86][l];
    const double w587 = w[37][l] * w478;
    const double w588 = c[178][l] * w587;
    const double w589 = w586 + w588;
    const double w590 = w589 * w93;
    const double w591 = w183 * w93;
    const double w592 = w591 * w396;
    const double w593 = c[83][l] * w590;
    const double w594 = c[184][l] * w592;
    const double w595 = w593 + w594;
    const double w596 = w585 * w595;
    const double w597 = w580 * w596;
    const double w598 = w186 * w186;
    const double w599 = c[179][l] * w598;
    const double w600 = w599 + 1.0;
    const double w601 = 1.0 / w600;
    const double w602 = w597 * w601;
    const double w603 = c[77][l] * w597;
    const double w604 = c[180][l] * w602;
    const double w605 = w603 + w604;
    const double w606 = (-100000.0) * w575;
    const double w607 = 100000.0 * w575;
    const double w608 = c[69][l] * w572;
    const double w609 = c[188][l] * w371;
    const double w610 = w[93][l] + w609;
    const double w611 = c[98][l] <= w198 ? 1.0 : 0.0;
    const double w612 = w198 <= c[98][l] ? 1.0 : 0.0;
    const double w613 = w611 + w612;
    const double w614 = 1.0 / w613;
    const double w615 = w611 * w614;
    const double w616 = w197 <= c[97][l] ? 1.0 : 0.0;
    const double w617 = c[97][l] <= w197 ? 1.0 : 0.0;
    const double w618 = w616 + w617;
    const double w619 = 1.0 / w618;
    const double w620 = w616 * w619;
    const double w621 = w620 * w[95][l];
    const double w622 = w615 * w621;
    const double w623 = 0.0 <= w201 ? 1.0 : 0.0;
    const double w624 = w201 <= 0.0 ? 1.0 : 0.0;
    const double w625 = w623 + w624;
    const double w626 = 1.0 / w625;
    const double w627 = w623 * w626;
    const double w628 = w627 * w622;
    const double w629 = w204 * w628;
    const double w630 = w203 * w628;
    const double w631 = w202 * w628;
    const double w632 = w202 * w631;
    const double w633 = c[190][l] * w630;
    const double w634 = c[192][l] * w632;
    const double w635 = w633 + w634;
    const double w636 = w206 * w635;
    const double w637 = 0.0 <= w209 ? 1.0 : 0.0;
    const double w638 = w209 <= 0.0 ? 1.0 : 0.0;
    const double w639 = w637 + w638;
    const double w640 = 1.0 / w639;
    const double w641 = w637 * w640;
    const double w642 = w641 * w622;
    const double w643 = w211 * w642;
    const double w644 = w210 * w642;
    const double w645 = w210 * w644;
    const double w646 = c[190][l] * w643;
    const double w647 = c[192][l] * w645;
    const double w648 = w646 + w647;
    const double w649 = w214 * w648;
    const double w650 = w212 * w642;
    const double w651 = c[26][l] * w622;
    const double w652 = c[191][l] * w629;
    const double w653 = w651 + w652;
    const double w654 = (-0.2) * w636;
    const double w655 = w653 + w654;
    const double w656 = (-0.2) * w649;
    const double w657 = w655 + w656;
    const double w658 = c[193][l] * w650;
    const double w659 = w657 + w658;
    const double w660 = w[49][l] * w659;
    const double w661 = w219 * w[96][l];
    const double w662 = c[102][l] * w660;
    const double w663 = c[102][l] * w661;
    const double w664 = w662 + w663;
    const double w665 = w223 * w[57][l];
    const double w666 = c[68][l] * w458;
    const double w667 = c[52][l] * w371;
    const double w668 = c[196][l] * w572;
    const double w669 = w[99][l] + w668;
    const double w670 = c[94][l] * w664;
    const double w671 = w669 + w670;
    const double w672 = c[113][l] * w665;
    const double w673 = w671 + w672;
    const double w674 = w234 * w[57][l];
    const double w675 = c[203][l] * w572;
    const double w676 = w[101][l] + w675;
    const double w677 = c[202][l] * w664;
    const double w678 = w676 + w677;
    const double w679 = c[123][l] * w674;
    const double w680 = w678 + w679;
    const double w681 = w25 * w[103][l];
    const double w682 = c[43][l] * w681;
    const double w683 = w[105][l] + w682;
    const double w684 = c[35][l] * w681;
    const double w685 = w[106][l] + w684;
    const double w686 = c[121][l] * w685;
    const double w687 = w683 + w686;
    const double w688 = w246 * w687;
    const double w689 = w265 * w688;
    const double w690 = w260 * w689;
    const double w691 = w259 * w690;
    const double w692 = w274 * w[110][l];
    const double w693 = w276 * w690;
    const double w694 = c[164][l] * w693;
    const double w695 = w692 + w694;
    const double w696 = w269 * w695;
    const double w697 = c[163][l] * w691;
    const double w698 = w697 + w696;
    const double w699 = c[165][l] * w690;
    const double w700 = 100000.0 * w698;
    const double w701 = w699 + w700;
    const double w702 = w287 * w701;
    const double w703 = w50 * w702;
    const double w704 = w49 * w702;
    const double w705 = w48 * w702;
    const double w706 = w48 * w705;
    const double w707 = 2.0 * w706;
    const double w708 = w704 + w707;
    const double w709 = w52 * w708;
    const double w710 = c[166][l] * w690;
    const double w711 = w710 + w700;
    const double w712 = w303 * w711;
    const double w713 = w57 * w712;
    const double w714 = w56 * w712;
    const double w715 = w56 * w714;
    const double w716 = 2.0 * w715;
    const double w717 = w713 + w716;
    const double w718 = w60 * w717;
    const double w719 = w58 * w712;
    const double w720 = 5e-06 * w703;
    const double w721 = w698 + w720;
    const double w722 = (-1e-05) * w709;
    const double w723 = w721 + w722;
    const double w724 = (-1e-05) * w718;
    const double w725 = w723 + w724;
    const double w726 = 5e-06 * w719;
    const double w727 = w725 + w726;
    const double w728 = w65 * w727;
    const double w729 = w728 * w323;
    const double w730 = w339 * w688;
    const double w731 = w[12][l] * w730;
    const double w732 = w73 * w[112][l];
    const double w733 = c[167][l] * w731;
    const double w734 = w733 + w732;
    const double w735 = w734 * w38;
    const double w736 = w346 * w689;
    const double w737 = c[49][l] * w735;
    const double w738 = c[168][l] * w736;
    const double w739 = w737 + w738;
    const double w740 = w334 * w739;
    const double w741 = w329 * w740;
    const double w742 = w741 * w356;
    const double w743 = c[60][l] * w741;
    const double w744 = c[170][l] * w742;
    const double w745 = w743 + w744;
    const double w746 = (-100000.0) * w729;
    const double w747 = 100000.0 * w729;
    const double w748 = w65 * w688;
    const double w749 = w34 * w727;
    const double w750 = c[48][l] * w748;
    const double w751 = w750 + w749;
    const double w752 = w37 * w751;
    const double w753 = w84 * w689;
    const double w754 = c[19][l] * w752;
    const double w755 = c[162][l] * w753;
    const double w756 = w754 + w755;
    const double w757 = c[47][l] * w685;
    const double w758 = w683 + w757;
    const double w759 = w392 * w758;
    const double w760 = w387 * w759;
    const double w761 = w382 * w760;
    const double w762 = w760 * w93;
    const double w763 = c[174][l] * w761;
    const double w764 = c[175][l] * w762;
    const double w765 = w763 + w764;
    const double w766 = w381 * w765;
    const double w767 = w403 * w[121][l];
    const double w768 = w766 + w767;
    const double w769 = w376 * w768;
    const double w770 = w407 * w765;
    const double w771 = -w770;
    const double w772 = w769 + w771;
    const double w773 = (-100000.0) * w765;
    const double w774 = (-100000.0) * w772;
    const double w775 = w773 + w774;
    const double w776 = w415 * w775;
    const double w777 = w107 * w776;
    const double w778 = w106 * w776;
    const double w779 = w106 * w778;
    const double w780 = 2.0 * w779;
    const double w781 = w777 + w780;
    const double w782 = w110 * w781;
    const double w783 = w108 * w776;
    const double w784 = 100000.0 * w772;
    const double w785 = w773 + w784;
    const double w786 = w431 * w785;
    const double w787 = w115 * w786;
    const double w788 = w114 * w786;
    const double w789 = w114 * w788;
    const double w790 = 2.0 * w789;
    const double w791 = w787 + w790;
    const double w792 = w118 * w791;
    const double w793 = w116 * w786;
    const double w794 = 1e-05 * w782;
    const double w795 = w772 + w794;
    const double w796 = (-5e-06) * w783;
    const double w797 = w795 + w796;
    const double w798 = (-1e-05) * w792;
    const double w799 = w797 + w798;
    const double w800 = 5e-06 * w793;
    const double w801 = w799 + w800;
    const double w802 = w89 * w801;
    const double w803 = w123 * w759;
    const double w804 = c[64][l] * w803;
    const double w805 = w802 + w804;
    const double w806 = w92 * w805;
    const double w807 = w124 * w760;
    const double w808 = c[10][l] * w806;
    const double w809 = c[176][l] * w807;
    const double w810 = w808 + w809;
    const double w811 = w123 * w801;
    const double w812 = w811 * w460;
    const double w813 = w133 * w[123][l];
    const double w814 = w477 * w759;
    const double w815 = w[25][l] * w814;
    const double w816 = c[178][l] * w815;
    const double w817 = w813 + w816;
    const double w818 = w817 * w93;
    const double w819 = w483 * w760;
    const double w820 = c[67][l] * w818;
    const double w821 = c[174][l] * w819;
    const double w822 = w820 + w821;
    const double w823 = w471 * w822;
    const double w824 = w466 * w823;
    const double w825 = w824 * w493;
    const double w826 = c[77][l] * w824;
    const double w827 = c[180][l] * w825;
    const double w828 = w826 + w827;
    const double w829 = (-100000.0) * w812;
    const double w830 = 100000.0 * w812;
    const double w831 = c[69][l] * w810;
    const double w832 = w511 * w760;
    const double w833 = c[185][l] * w762;
    const double w834 = c[184][l] * w832;
    const double w835 = w833 + w834;
    const double w836 = w510 * w835;
    const double w837 = w517 * w[131][l];
    const double w838 = w836 + w837;
    const double w839 = w505 * w838;
    const double w840 = w521 * w835;
    const double w841 = -w840;
    const double w842 = w839 + w841;
    const double w843 = (-100000.0) * w835;
    const double w844 = (-100000.0) * w842;
    const double w845 = w843 + w844;
    const double w846 = w529 * w845;
    const double w847 = w158 * w846;
    const double w848 = w157 * w846;
    const double w849 = w157 * w848;
    const double w850 = 2.0 * w849;
    const double w851 = w847 + w850;
    const double w852 = w161 * w851;
    const double w853 = w159 * w846;
    const double w854 = 100000.0 * w842;
    const double w855 = w843 + w854;
    const double w856 = w545 * w855;
    const double w857 = w166 * w856;
    const double w858 = w165 * w856;
    const double w859 = w165 * w858;
    const double w860 = 2.0 * w859;
    const double w861 = w857 + w860;
    const double w862 = w169 * w861;
    const double w863 = w167 * w856;
    const double w864 = 1e-05 * w852;
    const double w865 = w842 + w864;
    const double w866 = (-5e-06) * w853;
    const double w867 = w865 + w866;
    const double w868 = (-1e-05) * w862;
    const double w869 = w867 + w868;
    const double w870 = 5e-06 * w863;
    const double w871 = w869 + w870;
    const double w872 = w89 * w871;
    const double w873 = w174 * w759;
    const double w874 = c[64][l] * w873;
    const double w875 = w872 + w874;
    const double w876 = w92 * w875;
    const double w877 = w175 * w760;
    const double w878 = c[14][l] * w876;
    const double w879 = c[186][l] * w877;
    const double w880 = w878 + w879;
    const double w881 = w174 * w871;
    const double w882 = w881 * w574;
    const double w883 = w133 * w[133][l];
    const double w884 = w[37][l] * w814;
    const double w885 = c[178][l] * w884;
    const double w886 = w883 + w885;
    const double w887 = w886 * w93;
    const double w888 = w591 * w760;
    const double w889 = c[83][l] * w887;
    const double w890 = c[184][l] * w888;
    const double w891 = w889 + w890;
    const double w892 = w585 * w891;
    const double w893 = w580 * w892;
    const double w894 = w893 * w601;
    const double w895 = c[77][l] * w893;
    const double w896 = c[180][l] * w894;
    const double w897 = w895 + w896;
    const double w898 = (-100000.0) * w882;
    const double w899 = 100000.0 * w882;
    const double w900 = c[69][l] * w880;
    const double w901 = c[188][l] * w756;
    const double w902 = w[140][l] + w901;
    const double w903 = w620 * w[142][l];
    const double w904 = w615 * w903;
    const double w905 = w627 * w904;
    const double w906 = w204 * w905;
    const double w907 = w203 * w905;
    const double w908 = w202 * w905;
    const double w909 = w202 * w908;
    const double w910 = c[190][l] * w907;
    const double w911 = c[192][l] * w909;
    const double w912 = w910 + w911;
    const double w913 = w206 * w912;
    const double w914 = w641 * w904;
    const double w915 = w211 * w914;
    const double w916 = w210 * w914;
    const double w917 = w210 * w916;
    const double w918 = c[190][l] * w915;
    const double w919 = c[192][l] * w917;
    const double w920 = w918 + w919;
    const double w921 = w214 * w920;
    const double w922 = w212 * w914;
    const double w923 = c[26][l] * w904;
    const double w924 = c[191][l] * w906;
    const double w925 = w923 + w924;
    const double w926 = (-0.2) * w913;
    const double w927 = w925 + w926;
    const double w928 = (-0.2) * w921;
    const double w929 = w927 + w928;
    const double w930 = c[193][l] * w922;
    const double w931 = w929 + w930;
    const double w932 = w[49][l] * w931;
    const double w933 = w219 * w[143][l];
    const double w934 = c[102][l] * w932;
    const double w935 = c[102][l] * w933;
    const double w936 = w934 + w935;
    const double w937 = w223 * w[104][l];
    const double w938 = c[68][l] * w810;
    const double w939 = c[52][l] * w756;
    const double w940 = c[196][l] * w880;
    const double w941 = w[146][l] + w940;
    const double w942 = c[94][l] * w936;
    const double w943 = w941 + w942;
    const double w944 = c[113][l] * w937;
    const double w945 = w943 + w944;
    const double w946 = w234 * w[104][l];
    const double w947 = c[203][l] * w880;
    const double w948 = w[148][l] + w947;
    const double w949 = c[202][l] * w936;
    const double w950 = w948 + w949;
    const double w951 = c[123][l] * w946;
    const double w952 = w950 + w951;
    w[7][l] = w34;
    w[8][l] = w37;
    w[11][l] = w70;
    w[13][l] = w79;
    w[14][l] = w80;
    w[18][l] = w81;
    w[19][l] = w83;
    w[20][l] = w89;
    w[21][l] = w92;
    w[24][l] = w130;
    w[26][l] = w139;
    w[27][l] = w140;
    w[31][l] = w141;
    w[32][l] = w143;
    w[33][l] = w144;
    w[36][l] = w181;
    w[38][l] = w187;
    w[39][l] = w188;
    w[43][l] = w189;
    w[44][l] = w191;
    w[45][l] = w192;
    w[47][l] = w194;
    w[50][l] = w225;
    w[51][l] = w226;
    w[53][l] = w232;
    w[55][l] = w241;
    w[60][l] = w254;
    w[61][l] = w266;
    w[64][l] = w324;
    w[66][l] = w360;
    w[69][l] = w361;
    w[70][l] = w362;
    w[71][l] = w395;
    w[72][l] = w396;
    w[75][l] = w461;
    w[77][l] = w497;
    w[80][l] = w498;
    w[81][l] = w499;
    w[82][l] = w500;
    w[85][l] = w575;
    w[87][l] = w605;
    w[90][l] = w606;
    w[91][l] = w607;
    w[92][l] = w608;
    w[94][l] = w610;
    w[97][l] = w666;
    w[98][l] = w667;
    w[100][l] = w673;
    w[102][l] = w680;
    w[107][l] = w688;
    w[108][l] = w689;
    w[111][l] = w729;
    w[113][l] = w745;
    w[116][l] = w746;
    w[117][l] = w747;
    w[118][l] = w759;
    w[119][l] = w760;
    w[122][l] = w812;
    w[124][l] = w828;
    w[127][l] = w829;
    w[128][l] = w830;
    w[129][l] = w831;
    w[132][l] = w882;
    w[134][l] = w897;
    w[137][l] = w898;
    w[138][l] = w899;
    w[139][l] = w900;
    w[141][l] = w902;
    w[144][l] = w938;
    w[145][l] = w939;
    w[147][l] = w945;
    w[149][l] = w952;
}

INLINE void turn2(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[13][l]);
    const double w1 = c[59][l] * w0;
    const double w2 = w[14][l] + w1;
    const double w3 = c[20][l] * w2;
    const double w4 = lane_atan(w[26][l]);
    const double w5 = c[78][l] * w4;
    const double w6 = w[27][l] + w5;
    const double w7 = c[11][l] * w6;
    const double w8 = lane_atan(w[38][l]);
    const double w9 = c[78][l] * w8;
    const double w10 = w[39][l] + w9;
    const double w11 = c[11][l] * w10;
    const double w12 = w2 * w2;
    const double w13 = c[169][l] * w12;
    const double w14 = w13 + 1.0;
    const double w15 = 1.0 / w14;
    const double w16 = w[66][l] * w15;
    const double w17 = w6 * w6;
    const double w18 = c[179][l] * w17;
    const double w19 = w18 + 1.0;
    const double w20 = 1.0 / w19;
    const double w21 = w[77][l] * w20;
    const double w22 = w10 * w10;
    const double w23 = c[179][l] * w22;
    const double w24 = w23 + 1.0;
    const double w25 = 1.0 / w24;
    const double w26 = w[87][l] * w25;
    const double w27 = w[113][l] * w15;
    const double w28 = w[124][l] * w20;
    const double w29 = w[134][l] * w25;
    w[15][l] = w3;
    w[28][l] = w7;
    w[40][l] = w11;
    w[67][l] = w16;
    w[78][l] = w21;
    w[88][l] = w26;
    w[114][l] = w27;
    w[125][l] = w28;
    w[135][l] = w29;
}

INLINE void turn3(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[15][l]);
    const double w1 = c[21][l] * w0;
    const double w2 = lane_atan(w[28][l]);
    const double w3 = c[12][l] * w2;
    const double w4 = lane_atan(w[40][l]);
    const double w5 = c[12][l] * w4;
    w[16][l] = w1;
    w[29][l] = w3;
    w[41][l] = w5;
}

INLINE void turn4(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_sin(w[16][l]);
    const double w1 = w0 * w[17][l];
    const double w2 = w1 * w[9][l];
    const double w3 = c[22][l] * w2;
    const double w4 = lane_min(w[11][l], w3);
    const double w5 = lane_max(w[18][l], w4);
    const double w6 = (-100000.0) * w5;
    const double w7 = w[19][l] + w6;
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 100000.0 * w5;
    const double w15 = w[19][l] + w14;
    const double w16 = lane_max(0.0, w15);
    const double w17 = w16 * w16;
    const double w18 = w16 * w17;
    const double w19 = (-0.5) * w16;
    const double w20 = w19 + 1.0;
    const double w21 = w18 * w20;
    const double w22 = 1e-05 * w13;
    const double w23 = w5 + w22;
    const double w24 = (-1e-05) * w21;
    const double w25 = w23 + w24;
    const double w26 = w[7][l] * w25;
    const double w27 = w26 * w[8][l];
    const double w28 = lane_sin(w[29][l]);
    const double w29 = w28 * w[30][l];
    const double w30 = w29 * w[22][l];
    const double w31 = c[13][l] * w30;
    const double w32 = lane_min(w[24][l], w31);
    const double w33 = lane_max(w[31][l], w32);
    const double w34 = (-100000.0) * w33;
    const double w35 = w[32][l] + w34;
    const double w36 = lane_max(0.0, w35);
    const double w37 = w36 * w36;
    const double w38 = w36 * w37;
    const double w39 = (-0.5) * w36;
    const double w40 = w39 + 1.0;
    const double w41 = w38 * w40;
    const double w42 = 100000.0 * w33;
    const double w43 = w[32][l] + w42;
    const double w44 = lane_max(0.0, w43);
    const double w45 = w44 * w44;
    const double w46 = w44 * w45;
    const double w47 = (-0.5) * w44;
    const double w48 = w47 + 1.0;
    const double w49 = w46 * w48;
    const double w50 = 1e-05 * w41;
    const double w51 = w33 + w50;
    const double w52 = (-1e-05) * w49;
    const double w53 = w51 + w52;
    const double w54 = w[20][l] * w53;
    const double w55 = w54 * w[21][l];
    const double w56 = c[80][l] * w55;
    const double w57 = w[33][l] + w56;
    const double w58 = lane_sin(w[41][l]);
    const double w59 = w58 * w[42][l];
    const double w60 = w59 * w[34][l];
    const double w61 = c[13][l] * w60;
    const double w62 = lane_min(w[36][l], w61);
    const double w63 = lane_max(w[43][l], w62);
    const double w64 = (-100000.0) * w63;
    const double w65 = w[44][l] + w64;
    const double w66 = lane_max(0.0, w65);
    const double w67 = w66 * w66;
    const double w68 = w66 * w67;
    const double w69 = (-0.5) * w66;
    const double w70 = w69 + 1.0;
    const double w71 = w68 * w70;
    const double w72 = 100000.0 * w63;
    const double w73 = w[44][l] + w72;
    const double w74 = lane_max(0.0, w73);
    const double w75 = w74 * w74;
    const double w76 = w74 * w75;
    const double w77 = (-0.5) * w74;
    const double w78 = w77 + 1.0;
    const double w79 = w76 * w78;
    const double w80 = 1e-05 * w71;
    const double w81 = w63 + w80;
    const double w82 = (-1e-05) * w79;
    const double w83 = w81 + w82;
    const double w84 = w[20][l] * w83;
    const double w85 = w84 * w[21][l];
    const double w86 = c[88][l] * w85;
    const double w87 = w[45][l] + w86;
    const double w88 = c[92][l] * w27;
    const double w89 = w[47][l] + w88;
    const double w90 = c[94][l] * w57;
    const double w91 = w89 + w90;
    const double w92 = c[94][l] * w87;
    const double w93 = w91 + w92;
    const double w94 = c[74][l] * w55;
    const double w95 = w[50][l] + w94;
    const double w96 = c[109][l] * w27;
    const double w97 = w[51][l] + w96;
    const double w98 = c[114][l] * w85;
    const double w99 = w[53][l] + w98;
    const double w100 = c[94][l] * w95;
    const double w101 = w99 + w100;
    const double w102 = c[94][l] * w97;
    const double w103 = w101 + w102;
    const double w104 = c[125][l] * w57;
    const double w105 = w[55][l] + w104;
    const double w106 = c[130][l] * w85;
    const double w107 = w105 + w106;
    const double w108 = c[126][l] * w87;
    const double w109 = w107 + w108;
    const double w110 = c[127][l] * w95;
    const double w111 = w109 + w110;
    const double w112 = c[128][l] * w97;
    const double w113 = w111 + w112;
    const double w114 = w25 * w[60][l];
    const double w115 = w4 <= w[18][l] ? 1.0 : 0.0;
    const double w116 = w[18][l] <= w4 ? 1.0 : 0.0;
    const double w117 = w115 + w116;
    const double w118 = 1.0 / w117;
    const double w119 = w115 * w118;
    const double w120 = w119 * w[64][l];
    const double w121 = w116 * w118;
    const double w122 = w3 <= w[11][l] ? 1.0 : 0.0;
    const double w123 = w[11][l] <= w3 ? 1.0 : 0.0;
    const double w124 = w122 + w123;
    const double w125 = 1.0 / w124;
    const double w126 = w122 * w125;
    const double w127 = lane_cos(w[16][l]);
    const double w128 = w127 * w[67][l];
    const double w129 = w[17][l] * w128;
    const double w130 = w0 * w[68][l];
    const double w131 = c[171][l] * w129;
    const double w132 = c[172][l] * w130;
    const double w133 = w131 + w132;
    const double w134 = w133 * w[9][l];
    const double w135 = w2 * w[9][l];
    const double w136 = w135 * w[62][l];
    const double w137 = c[173][l] * w136;
    const double w138 = w134 + w137;
    const double w139 = w126 * w138;
    const double w140 = w123 * w125;
    const double w141 = w140 * w[64][l];
    const double w142 = -w141;
    const double w143 = w139 + w142;
    const double w144 = w121 * w143;
    const double w145 = w120 + w144;
    const double w146 = 0.0 <= w7 ? 1.0 : 0.0;
    const double w147 = w7 <= 0.0 ? 1.0 : 0.0;
    const double w148 = w146 + w147;
    const double w149 = 1.0 / w148;
    const double w150 = w146 * w149;
    const double w151 = 100000.0 * w145;
    const double w152 = w[69][l] + w151;
    const double w153 = w150 * w152;
    const double w154 = w10 * w153;
    const double w155 = w9 * w153;
    const double w156 = w8 * w153;
    const double w157 = w8 * w156;
    const double w158 = 2.0 * w157;
    const double w159 = w155 + w158;
    const double w160 = w12 * w159;
    const double w161 = 0.0 <= w15 ? 1.0 : 0.0;
    const double w162 = w15 <= 0.0 ? 1.0 : 0.0;
    const double w163 = w161 + w162;
    const double w164 = 1.0 / w163;
    const double w165 = w161 * w164;
    const double w166 = w[70][l] + w151;
    const double w167 = w165 * w166;
    const double w168 = w17 * w167;
    const double w169 = w16 * w167;
    const double w170 = w16 * w169;
    const double w171 = 2.0 * w170;
    const double w172 = w168 + w171;
    const double w173 = w20 * w172;
    const double w174 = w18 * w167;
    const double w175 = 5e-06 * w154;
    const double w176 = w145 + w175;
    const double w177 = (-1e-05) * w160;
    const double w178 = w176 + w177;
    const double w179 = (-1e-05) * w173;
    const double w180 = w178 + w179;
    const double w181 = 5e-06 * w174;
    const double w182 = w180 + w181;
    const double w183 = w[7][l] * w182;
    const double w184 = c[48][l] * w114;
    const double w185 = w184 + w183;
    const double w186 = w[8][l] * w185;
    const double w187 = w26 * w[61][l];
    const double w188 = c[19][l] * w186;
    const double w189 = c[162][l] * w187;
    const double w190 = w188 + w189;
    const double w191 = w32 <= w[31][l] ? 1.0 : 0.0;
    const double w192 = w[31][l] <= w32 ? 1.0 : 0.0;
    const double w193 = w191 + w192;
    const double w194 = 1.0 / w193;
    const double w195 = w191 * w194;
    const double w196 = w195 * w[75][l];
    const double w197 = w192 * w194;
    const double w198 = w31 <= w[24][l] ? 1.0 : 0.0;
    const double w199 = w[24][l] <= w31 ? 1.0 : 0.0;
    const double w200 = w198 + w199;
    const double w201 = 1.0 / w200;
    const double w202 = w198 * w201;
    const double w203 = lane_cos(w[29][l]);
    const double w204 = w203 * w[78][l];
    const double w205 = w[30][l] * w204;
    const double w206 = w28 * w[79][l];
    const double w207 = c[181][l] * w205;
    const double w208 = c[182][l] * w206;
    const double w209 = w207 + w208;
    const double w210 = w209 * w[22][l];
    const double w211 = w30 * w[22][l];
    const double w212 = w211 * w[73][l];
    const double w213 = c[183][l] * w212;
    const double w214 = w210 + w213;
    const double w215 = w202 * w214;
    const double w216 = w199 * w201;
    const double w217 = w216 * w[75][l];
    const double w218 = -w217;
    const double w219 = w215 + w218;
    const double w220 = w197 * w219;
    const double w221 = w196 + w220;
    const double w222 = 0.0 <= w35 ? 1.0 : 0.0;
    const double w223 = w35 <= 0.0 ? 1.0 : 0.0;
    const double w224 = w222 + w223;
    const double w225 = 1.0 / w224;
    const double w226 = w222 * w225;
    const double w227 = 100000.0 * w221;
    const double w228 = w[80][l] + w227;
    const double w229 = w226 * w228;
    const double w230 = w38 * w229;
    const double w231 = w37 * w229;
    const double w232 = w36 * w229;
    const double w233 = w36 * w232;
    const double w234 = 2.0 * w233;
    const double w235 = w231 + w234;
    const double w236 = w40 * w235;
    const double w237 = 0.0 <= w43 ? 1.0 : 0.0;
    const double w238 = w43 <= 0.0 ? 1.0 : 0.0;
    const double w239 = w237 + w238;
    const double w240 = 1.0 / w239;
    const double w241 = w237 * w240;
    const double w242 = w[81][l] + w227;
    const double w243 = w241 * w242;
    const double w244 = w45 * w243;
    const double w245 = w44 * w243;
    const double w246 = w44 * w245;
    const double w247 = 2.0 * w246;
    const double w248 = w244 + w247;
    const double w249 = w48 * w248;
    const double w250 = w46 * w243;
    const double w251 = 5e-06 * w230;
    const double w252 = w221 + w251;
    const double w253 = (-1e-05) * w236;
    const double w254 = w252 + w253;
    const double w255 = (-1e-05) * w249;
    const double w256 = w254 + w255;
    const double w257 = 5e-06 * w250;
    const double w258 = w256 + w257;
    const double w259 = w[20][l] * w258;
    const double w260 = w53 * w[71][l];
    const double w261 = c[64][l] * w260;
    const double w262 = w259 + w261;
    const double w263 = w[21][l] * w262;
    const double w264 = w54 * w[72][l];
    const double w265 = c[10][l] * w263;
    const double w266 = c[176][l] * w264;
    const double w267 = w265 + w266;
    const double w268 = c[71][l] * w267;
    const double w269 = w[82][l] + w268;
    const double w270 = w62 <= w[43][l] ? 1.0 : 0.0;
    const double w271 = w[43][l] <= w62 ? 1.0 : 0.0;
    const double w272 = w270 + w271;
    const double w273 = 1.0 / w272;
    const double w274 = w270 * w273;
    const double w275 = w274 * w[85][l];
    const double w276 = w271 * w273;
    const double w277 = w61 <= w[36][l] ? 1.0 : 0.0;
    const double w278 = w[36][l] <= w61 ? 1.0 : 0.0;
    const double w279 = w277 + w278;
    const double w280 = 1.0 / w279;
    const double w281 = w277 * w280;
    const double w282 = lane_cos(w[41][l]);
    const double w283 = w282 * w[88][l];
    const double w284 = w[42][l] * w283;
    const double w285 = w58 * w[89][l];
    const double w286 = c[181][l] * w284;
    const double w287 = c[182][l] * w285;
    const double w288 = w286 + w287;
    const double w289 = w288 * w[34][l];
    const double w290 = w60 * w[34][l];
    const double w291 = w290 * w[83][l];
    const double w292 = c[183][l] * w291;
    const double w293 = w289 + w292;
    const double w294 = w281 * w293;
    const double w295 = w278 * w280;
    const double w296 = w295 * w[85][l];
    const double w297 = -w296;
    const double w298 = w294 + w297;
    const double w299 = w276 * w298;
    const double w300 = w275 + w299;
    const double w301 = 0.0 <= w65 ? 1.0 : 0.0;
    const double w302 = w65 <= 0.0 ? 1.0 : 0.0;
    const double w303 = w301 + w302;
    const double w304 = 1.0 / w303;
    const double w305 = w301 * w304;
    const double w306 = 100000.0 * w300;
    const double w307 = w[90][l] + w306;
    const double w308 = w305 * w307;
    const double w309 = w68 * w308;
    const double w310 = w67 * w308;
    const double w311 = w66 * w308;
    const double w312 = w66 * w311;
    const double w313 = 2.0 * w312;
    const double w314 = w310 + w313;
    const double w315 = w70 * w314;
    const double w316 = 0.0 <= w73 ? 1.0 : 0.0;
    const double w317 = w73 <= 0.0 ? 1.0 : 0.0;
    const double w318 = w316 + w317;
    const double w319 = 1.0 / w318;
    const double w320 = w316 * w319;
    const double w321 = w[91][l] + w306;
    const double w322 = w320 * w321;
    const double w323 = w75 * w322;
    const double w324 = w74 * w322;
    const double w325 = w74 * w324;
    const double w326 = 2.0 * w325;
    const double w327 = w323 + w326;
    const double w328 = w78 * w327;
    const double w329 = w76 * w322;
    const double w330 = 5e-06 * w309;
    const double w331 = w300 + w330;
    const double w332 = (-1e-05) * w315;
    const double w333 = w331 + w332;
    const double w334 = (-1e-05) * w328;
    const double w335 = w333 + w334;
    const double w336 = 5e-06 * w329;
    const double w337 = w335 + w336;
    const double w338 = w[20][l] * w337;
    const double w339 = w83 * w[71][l];
    const double w340 = c[64][l] * w339;
    const double w341 = w338 + w340;
    const double w342 = w[21][l] * w341;
    const double w343 = w84 * w[72][l];
    const double w344 = c[14][l] * w342;
    const double w345 = c[186][l] * w343;
    const double w346 = w344 + w345;
    const double w347 = c[68][l] * w346;
    const double w348 = w[92][l] + w347;
    const double w349 = c[187][l] * w190;
    const double w350 = w[94][l] + w349;
    const double w351 = c[94][l] * w269;
    const double w352 = w350 + w351;
    const double w353 = c[94][l] * w348;
    const double w354 = w352 + w353;
    const double w355 = c[69][l] * w267;
    const double w356 = w[97][l] + w355;
    const double w357 = c[195][l] * w190;
    const double w358 = w[98][l] + w357;
    const double w359 = c[199][l] * w346;
    const double w360 = w[100][l] + w359;
    const double w361 = c[94][l] * w356;
    const double w362 = w360 + w361;
    const double w363 = c[94][l] * w358;
    const double w364 = w362 + w363;
    const double w365 = c[125][l] * w269;
    const double w366 = w[102][l] + w365;
    const double w367 = c[204][l] * w346;
    const double w368 = w366 + w367;
    const double w369 = c[126][l] * w348;
    const double w370 = w368 + w369;
    const double w371 = c[127][l] * w356;
    const double w372 = w370 + w371;
    const double w373 = c[128][l] * w358;
    const double w374 = w372 + w373;
    const double w375 = w25 * w[107][l];
    const double w376 = w119 * w[111][l];
    const double w377 = w127 * w[114][l];
    const double w378 = w[17][l] * w377;
    const double w379 = w0 * w[115][l];
    const double w380 = c[171][l] * w378;
    const double w381 = c[172][l] * w379;
    const double w382 = w380 + w381;
    const double w383 = w382 * w[9][l];
    const double w384 = w135 * w[109][l];
    const double w385 = c[173][l] * w384;
    const double w386 = w383 + w385;
    const double w387 = w126 * w386;
    const double w388 = w140 * w[111][l];
    const double w389 = -w388;
    const double w390 = w387 + w389;
    const double w391 = w121 * w390;
    const double w392 = w376 + w391;
    const double w393 = 100000.0 * w392;
    const double w394 = w[116][l] + w393;
    const double w395 = w150 * w394;
    const double w396 = w10 * w395;
    const double w397 = w9 * w395;
    const double w398 = w8 * w395;
    const double w399 = w8 * w398;
    const double w400 = 2.0 * w399;
    const double w401 = w397 + w400;
    const double w402 = w12 * w401;
    const double w403 = w[117][l] + w393;
    const double w404 = w165 * w403;
    const double w405 = w17 * w404;
    const double w406 = w16 * w404;
    const double w407 = w16 * w406;
    const double w408 = 2.0 * w407;
    const double w409 = w405 + w408;
    const double w410 = w20 * w409;
    const double w411 = w18 * w404;
    const double w412 = 5e-06 * w396;
    const double w413 = w392 + w412;
    const double w414 = (-1e-05) * w402;
    const double w415 = w413 + w414;
    const double w416 = (-1e-05) * w410;
    const double w417 = w415 + w416;
    const double w418 = 5e-06 * w411;
    const double w419 = w417 + w418;
    const double w420 = w[7][l] * w419;
    const double w421 = c[48][l] * w375;
    const double w422 = w421 + w420;
    const double w423 = w[8][l] * w422;
    const double w424 = w26 * w[108][l];
    const double w425 = c[19][l] * w423;
    const double w426 = c[162][l] * w424;
    const double w427 = w425 + w426;
    const double w428 = w195 * w[122][l];
    const double w429 = w203 * w[125][l];
    const double w430 = w[30][l] * w429;
    const double w431 = w28 * w[126][l];
    const double w432 = c[181][l] * w430;
    const double w433 = c[182][l] * w431;
    const double w434 = w432 + w433;
    const double w435 = w434 * w[22][l];
    const double w436 = w211 * w[120][l];
    const double w437 = c[183][l] * w436;
    const double w438 = w435 + w437;
    const double w439 = w202 * w438;
    const double w440 = w216 * w[122][l];
    const double w441 = -w440;
    const double w442 = w439 + w441;
    const double w443 = w197 * w442;
    const double w444 = w428 + w443;
    const double w445 = 100000.0 * w444;
    const double w446 = w[127][l] + w445;
    const double w447 = w226 * w446;
    const double w448 = w38 * w447;
    const double w449 = w37 * w447;
    const double w450 = w36 * w447;
    const double w451 = w36 * w450;
    const double w452 = 2.0 * w451;
    const double w453 = w449 + w452;
    const double w454 = w40 * w453;
    const double w455 = w[128][l] + w445;
    const double w456 = w241 * w455;
    const double w457 = w45 * w456;
    const double w458 = w44 * w456;
    const double w459 = w44 * w458;
    const double w460 = 2.0 * w459;
    const double w461 = w457 + w460;
    const double w462 = w48 * w461;
    const double w463 = w46 * w456;
    const double w464 = 5e-06 * w448;
    const double w465 = w444 + w464;
    const double w466 = (-1e-05) * w454;
    const double w467 = w465 + w466;
    const double w468 = (-1e-05) * w462;
    const double w469 = w467 + w468;
    const double w470 = 5e-06 * w463;
    const double w471 = w469 + w470;
    const double w472 = w[20][l] * w471;
    const double w473 = w53 * w[118][l];
    const double w474 = c[64][l] * w473;
    const double w475 = w472 + w474;
    const double w476 = w[21][l] * w475;
    const double w477 = w54 * w[119][l];
    const double w478 = c[10][l] * w476;
    const double w479 = c[176][l] * w477;
    const double w480 = w478 + w479;
    const double w481 = c[71][l] * w480;
    const double w482 = w[129][l] + w481;
    const double w483 = w274 * w[132][l];
    const double w484 = w282 * w[135][l];
    const double w485 = w[42][l] * w484;
    const double w486 = w58 * w[136][l];
    const double w487 = c[181][l] * w485;
    const double w488 = c[182][l] * w486;
    const double w489 = w487 + w488;
    const double w490 = w489 * w[34][l];
    const double w491 = w290 * w[130][l];
    const double w492 = c[183][l] * w491;
    const double w493 = w490 + w492;
    const double w494 = w281 * w493;
    const double w495 = w295 * w[132][l];
    const double w496 = -w495;
    const double w497 = w494 + w496;
    const double w498 = w276 * w497;
    const double w499 = w483 + w498;
    const double w500 = 100000.0 * w499;
    const double w501 = w[137][l] + w500;
    const double w502 = w305 * w501;
    const double w503 = w68 * w502;
    const double w504 = w67 * w502;
    const double w505 = w66 * w502;
    const double w506 = w66 * w505;
    const double w507 = 2.0 * w506;
    const double w508 = w504 + w507;
    const double w509 = w70 * w508;
    const double w510 = w[138][l] + w500;
    const double w511 = w320 * w510;
    const double w512 = w75 * w511;
    const double w513 = w74 * w511;
    const double w514 = w74 * w513;
    const double w515 = 2.0 * w514;
    const double w516 = w512 + w515;
    const double w517 = w78 * w516;
    const double w518 = w76 * w511;
    const double w519 = 5e-06 * w503;
    const double w520 = w499 + w519;
    const double w521 = (-1e-05) * w509;
    const double w522 = w520 + w521;
    const double w523 = (-1e-05) * w517;
    const double w524 = w522 + w523;
    const double w525 = 5e-06 * w518;
    const double w526 = w524 + w525;
    const double w527 = w[20][l] * w526;
    const double w528 = w83 * w[118][l];
    const double w529 = c[64][l] * w528;
    const double w530 = w527 + w529;
    const double w531 = w[21][l] * w530;
    const double w532 = w84 * w[119][l];
    const double w533 = c[14][l] * w531;
    const double w534 = c[186][l] * w532;
    const double w535 = w533 + w534;
    const double w536 = c[68][l] * w535;
    const double w537 = w[139][l] + w536;
    const double w538 = c[187][l] * w427;
    const double w539 = w[141][l] + w538;
    const double w540 = c[94][l] * w482;
    const double w541 = w539 + w540;
    const double w542 = c[94][l] * w537;
    const double w543 = w541 + w542;
    const double w544 = c[69][l] * w480;
    const double w545 = w[144][l] + w544;
    const double w546 = c[195][l] * w427;
    const double w547 = w[145][l] + w546;
    const double w548 = c[199][l] * w535;
    const double w549 = w[147][l] + w548;
    const double w550 = c[94][l] * w545;
    const double w551 = w549 + w550;
    const double w552 = c[94][l] * w547;
    const double w553 = w551 + w552;
    const double w554 = c[125][l] * w482;
    const double w555 = w[149][l] + w554;
    const double w556 = c[204][l] * w535;
    const double w557 = w555 + w556;
    const double w558 = c[126][l] * w537;
    const double w559 = w557 + w558;
    const double w560 = c[127][l] * w545;
    const double w561 = w559 + w560;
    const double w562 = c[128][l] * w547;
    const double w563 = w561 + w562;
    WRITE(f, S0, w93);
    WRITE(f, S1, w103);
    WRITE(f, S2, w113);
    WRITE(r, S0, w354);
    WRITE(r, S1, w364);
    WRITE(r, S2, w374);
    WRITE_MOVING(g, S0, w543);
    WRITE_MOVING(g, S1, w553);
    WRITE_MOVING(g, S2, w563);
}

APART void turns(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g)
{
    lanes w[150];
    LANE_LOOP turn0(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn1(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn2(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn3(c, u, x, e, m, f, r, g, w, l);
    LANE_LOOP turn4(c, u, x, e, m, f, r, g, w, l);
}
#endif

INLINE void output(const lanes *c, int l, double x0, double x1, double x2, double x4, double x5, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10, double *y11, double *y12, double *y13, double *y14, double *y15, double *y16, double *y17, double *y18, double *y19, double *y20, double *y21, double *y22, double *y23, double *y24, double *y25, double *y26, double *y27, double *y28, double *y29, double *y30, double *y31, double *y32, double *y33, double *y34, double *y35, double *y36, double *y37, double *y38)
{
    const double w0 = lane_cos(x5);
    const double w1 = lane_sin(x5);
    const double w2 = c[0][l] * w0;
    const double w3 = c[1][l] * w1;
    const double w4 = w2 + w3;
    const double w5 = -w4;
    const double w6 = x0 + w5;
    const double w7 = w6 * w6;
    const double w8 = w7 + 0.0001;
    const double w9 = sqrt(w8);
    const double w10 = w6 * w9;
    const double w11 = w10 + c[32][l];
    const double w12 = w11 * w11;
    const double w13 = w12 + 1e-08;
    const double w14 = sqrt(w13);
    const double w15 = 0.5 * w10;
    const double w16 = w15 + c[31][l];
    const double w17 = 0.5 * w14;
    const double w18 = w16 + w17;
    const double w19 = sqrt(w18);
    const double w20 = lane_atan2(0.0, w19);
    const double w21 = c[30][l] * w20;
    const double w22 = w21 + c[33][l];
    const double w23 = c[5][l] * w22;
    const double w24 = lane_min(c[28][l], w23);
    const double w25 = lane_max(c[29][l], w24);
    const double w26 = (-5.0) * w25;
    const double w27 = w26 + c[34][l];
    const double w28 = lane_max(0.0, w27);
    const double w29 = w28 * w28;
    const double w30 = w28 * w29;
    const double w31 = (-0.5) * w28;
    const double w32 = w31 + 1.0;
    const double w33 = w30 * w32;
    const double w34 = 5.0 * w25;
    const double w35 = w34 + c[34][l];
    const double w36 = lane_max(0.0, w35);
    const double w37 = w36 * w36;
    const double w38 = w36 * w37;
    const double w39 = (-0.5) * w36;
    const double w40 = w39 + 1.0;
    const double w41 = w38 * w40;
    const double w42 = 0.2 * w33;
    const double w43 = w25 + w42;
    const double w44 = (-0.2) * w41;
    const double w45 = w43 + w44;
    const double w46 = w45 * w18;
    const double w47 = w7 + 1e-08;
    const double w48 = c[1][l] * w0;
    const double w49 = c[38][l] * w1;
    const double w50 = w48 + w49;
    const double w51 = -w50;
    const double w52 = x1 + w51;
    const double w53 = w52 * w52;
    const double w54 = w47 + w53;
    const double w55 = w54 * w6;
    const double w56 = sqrt(w47);
    const double w57 = 1.0 / w56;
    const double w58 = w55 * w57;
    const double w59 = c[41][l] * w58;
    const double w60 = w59 + c[27][l];
    const double w61 = c[36][l] * w46;
    const double w62 = w60 + w61;
    const double w63 = c[44][l] * w54;
    const double w64 = w63 + c[45][l];
    const double w65 = c[43][l] * w46;
    const double w66 = w64 + w65;
    const double w67 = c[42][l] * w62;
    const double w68 = w67 + w66;
    const double w69 = c[48][l] * w68;
    const double w70 = lane_max(0.0, w69);
    const double w71 = c[18][l] * w70;
    const double w72 = w71 + c[17][l];
    const double w73 = lane_max(0.001, w72);
    const double w74 = 1.0 / w73;
    const double w75 = c[50][l] * w74;
    const double w76 = w75 + 5e-06;
    const double w77 = c[46][l] * x2;
    const double w78 = x1 + w77;
    const double w79 = c[51][l] * x0;
    const double w80 = c[52][l] * w78;
    const double w81 = w79 + w80;
    const double w82 = w81 * w81;
    const double w83 = c[54][l] * x0;
    const double w84 = c[51][l] * w78;
    const double w85 = w83 + w84;
    const double w86 = w85 * w85;
    const double w87 = w82 + w86;
    const double w88 = w87 * w87;
    const double w89 = w88 + c[53][l];
    const double w90 = sqrt(w89);
    const double w91 = sqrt(w90);
    const double w92 = 1.0 / w91;
    const double w93 = w81 * w92;
    const double w94 = lane_min(w76, w93);
    const double w95 = -w76;
    const double w96 = lane_max(w95, w94);
    const double w97 = c[55][l] * w74;
    const double w98 = w97 + 0.5;
    const double w99 = (-100000.0) * w96;
    const double w100 = w98 + w99;
    const double w101 = lane_max(0.0, w100);
    const double w102 = w101 * w101;
    const double w103 = w101 * w102;
    const double w104 = (-0.5) * w101;
    const double w105 = w104 + 1.0;
    const double w106 = w103 * w105;
    const double w107 = 100000.0 * w96;
    const double w108 = w98 + w107;
    const double w109 = lane_max(0.0, w108);
    const double w110 = w109 * w109;
    const double w111 = w109 * w110;
    const double w112 = (-0.5) * w109;
    const double w113 = w112 + 1.0;
    const double w114 = w111 * w113;
    const double w115 = 1e-05 * w106;
    const double w116 = w96 + w115;
    const double w117 = (-1e-05) * w114;
    const double w118 = w116 + w117;
    const double w119 = w118 * w118;
    const double w120 = -w119;
    const double w121 = w120 + 1.0;
    const double w122 = sqrt(w121);
    const double w123 = w122 + 5e-06;
    const double w124 = c[16][l] * w70;
    const double w125 = w124 + c[15][l];
    const double w126 = lane_max(0.0, w125);
    const double w127 = w82 + c[58][l];
    const double w128 = sqrt(w127);
    const double w129 = 1.0 / w128;
    const double w130 = w85 * w129;
    const double w131 = w126 * w130;
    const double w132 = w131 * w74;
    const double w133 = c[49][l] * w132;
    const double w134 = lane_min(w133, c[56][l]);
    const double w135 = lane_max(c[57][l], w134);
    const double w136 = c[20][l] * w135;
    const double w137 = lane_atan(w136);
    const double w138 = c[60][l] * w135;
    const double w139 = c[59][l] * w137;
    const double w140 = w138 + w139;
    const double w141 = c[20][l] * w140;
    const double w142 = lane_atan(w141);
    const double w143 = c[21][l] * w142;
    const double w144 = lane_sin(w143);
    const double w145 = w86 + w127;
    const double w146 = sqrt(w145);
    const double w147 = w144 * w146;
    const double w148 = w147 * w92;
    const double w149 = c[22][l] * w148;
    const double w150 = lane_min(w123, w149);
    const double w151 = -w123;
    const double w152 = lane_max(w151, w150);
    const double w153 = (-100000.0) * w122;
    const double w154 = w153 + 0.5;
    const double w155 = (-100000.0) * w152;
    const double w156 = w154 + w155;
    const double w157 = lane_max(0.0, w156);
    const double w158 = w157 * w157;
    const double w159 = w157 * w158;
    const double w160 = (-0.5) * w157;
    const double w161 = w160 + 1.0;
    const double w162 = w159 * w161;
    const double w163 = 100000.0 * w152;
    const double w164 = w154 + w163;
    const double w165 = lane_max(0.0, w164);
    const double w166 = w165 * w165;
    const double w167 = w165 * w166;
    const double w168 = (-0.5) * w165;
    const double w169 = w168 + 1.0;
    const double w170 = w167 * w169;
    const double w171 = 1e-05 * w162;
    const double w172 = w152 + w171;
    const double w173 = (-1e-05) * w170;
    const double w174 = w172 + w173;
    const double w175 = w70 * w174;
    const double w176 = w175 * w73;
    const double w177 = w70 * w118;
    const double w178 = w177 * w73;
    const double w179 = c[46][l] * w62;
    const double w180 = w179 + w66;
    const double w181 = c[64][l] * w180;
    const double w182 = lane_max(0.0, w181);
    const double w183 = c[9][l] * w182;
    const double w184 = w183 + c[8][l];
    const double w185 = lane_max(0.001, w184);
    const double w186 = 1.0 / w185;
    const double w187 = c[65][l] * w185;
    const double w188 = w187 + c[66][l];
    const double w189 = w188 * w186;
    const double w190 = c[67][l] * w189;
    const double w191 = w190 + 5e-06;
    const double w192 = c[42][l] * x2;
    const double w193 = x1 + w192;
    const double w194 = c[69][l] * x0;
    const double w195 = c[70][l] * x2;
    const double w196 = w194 + w195;
    const double w197 = c[68][l] * w193;
    const double w198 = w196 + w197;
    const double w199 = w198 * w198;
    const double w200 = c[71][l] * x0;
    const double w201 = c[72][l] * x2;
    const double w202 = w200 + w201;
    const double w203 = c[69][l] * w193;
    const double w204 = w202 + w203;
    const double w205 = w204 * w204;
    const double w206 = w199 + w205;
    const double w207 = w206 * w206;
    const double w208 = w207 + c[53][l];
    const double w209 = sqrt(w208);
    const double w210 = sqrt(w209);
    const double w211 = 1.0 / w210;
    const double w212 = w198 * w211;
    const double w213 = lane_min(w191, w212);
    const double w214 = -w191;
    const double w215 = lane_max(w214, w213);
    const double w216 = c[73][l] * w189;
    const double w217 = w216 + 0.5;
    const double w218 = (-100000.0) * w215;
    const double w219 = w217 + w218;
    const double w220 = lane_max(0.0, w219);
    const double w221 = w220 * w220;
    const double w222 = w220 * w221;
    const double w223 = (-0.5) * w220;
    const double w224 = w223 + 1.0;
    const double w225 = w222 * w224;
    const double w226 = 100000.0 * w215;
    const double w227 = w217 + w226;
    const double w228 = lane_max(0.0, w227);
    const double w229 = w228 * w228;
    const double w230 = w228 * w229;
    const double w231 = (-0.5) * w228;
    const double w232 = w231 + 1.0;
    const double w233 = w230 * w232;
    const double w234 = 1e-05 * w225;
    const double w235 = w215 + w234;
    const double w236 = (-1e-05) * w233;
    const double w237 = w235 + w236;
    const double w238 = w182 * w237;
    const double w239 = w238 * w185;
    const double w240 = w237 * w237;
    const double w241 = -w240;
    const double w242 = w241 + 1.0;
    const double w243 = sqrt(w242);
    const double w244 = w243 + 5e-06;
    const double w245 = c[7][l] * w182;
    const double w246 = w245 + c[6][l];
    const double w247 = lane_max(0.0, w246);
    const double w248 = w199 + c[58][l];
    const double w249 = sqrt(w248);
    const double w250 = 1.0 / w249;
    const double w251 = w204 * w250;
    const double w252 = w247 * w251;
    const double w253 = w252 * w186;
    const double w254 = c[67][l] * w253;
    const double w255 = lane_min(w254, c[75][l]);
    const double w256 = lane_max(c[76][l], w255);
    const double w257 = c[11][l] * w256;
    const double w258 = lane_atan(w257);
    const double w259 = c[77][l] * w256;
    const double w260 = c[78][l] * w258;
    const double w261 = w259 + w260;
    const double w262 = c[11][l] * w261;
    const double w263 = lane_atan(w262);
    const double w264 = c[12][l] * w263;
    const double w265 = lane_sin(w264);
    const double w266 = w205 + w248;
    const double w267 = sqrt(w266);
    const double w268 = w265 * w267;
    const double w269 = w268 * w211;
    const double w270 = c[13][l] * w269;
    const double w271 = lane_min(w244, w270);
    const double w272 = -w244;
    const double w273 = lane_max(w272, w271);
    const double w274 = (-100000.0) * w243;
    const double w275 = w274 + 0.5;
    const double w276 = (-100000.0) * w273;
    const double w277 = w275 + w276;
    const double w278 = lane_max(0.0, w277);
    const double w279 = w278 * w278;
    const double w280 = w278 * w279;
    const double w281 = (-0.5) * w278;
    const double w282 = w281 + 1.0;
    const double w283 = w280 * w282;
    const double w284 = 100000.0 * w273;
    const double w285 = w275 + w284;
    const double w286 = lane_max(0.0, w285);
    const double w287 = w286 * w286;
    const double w288 = w286 * w287;
    const double w289 = (-0.5) * w286;
    const double w290 = w289 + 1.0;
    const double w291 = w288 * w290;
    const double w292 = 1e-05 * w283;
    const double w293 = w273 + w292;
    const double w294 = (-1e-05) * w291;
    const double w295 = w293 + w294;
    const double w296 = w182 * w295;
    const double w297 = w296 * w185;
    const double w298 = c[74][l] * w239;
    const double w299 = c[80][l] * w297;
    const double w300 = w298 + w299;
    const double w301 = c[81][l] * w185;
    const double w302 = w301 + c[82][l];
    const double w303 = w302 * w186;
    const double w304 = c[83][l] * w303;
    const double w305 = w304 + 5e-06;
    const double w306 = c[84][l] * x2;
    const double w307 = w194 + w306;
    const double w308 = c[71][l] * w193;
    const double w309 = w307 + w308;
    const double w310 = w309 * w309;
    const double w311 = c[68][l] * x0;
    const double w312 = c[85][l] * x2;
    const double w313 = w311 + w312;
    const double w314 = w313 + w203;
    const double w315 = w314 * w314;
    const double w316 = w310 + w315;
    const double w317 = w316 * w316;
    const double w318 = w317 + c[53][l];
    const double w319 = sqrt(w318);
    const double w320 = sqrt(w319);
    const double w321 = 1.0 / w320;
    const double w322 = w309 * w321;
    const double w323 = lane_min(w305, w322);
    const double w324 = -w305;
    const double w325 = lane_max(w324, w323);
    const double w326 = c[86][l] * w303;
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
    const double w348 = w182 * w347;
    const double w349 = w348 * w185;
    const double w350 = w347 * w347;
    const double w351 = -w350;
    const double w352 = w351 + 1.0;
    const double w353 = sqrt(w352);
    const double w354 = w353 + 5e-06;
    const double w355 = w310 + c[58][l];
    const double w356 = sqrt(w355);
    const double w357 = 1.0 / w356;
    const double w358 = w314 * w357;
    const double w359 = w247 * w358;
    const double w360 = w359 * w186;
    const double w361 = c[83][l] * w360;
    const double w362 = lane_min(w361, c[75][l]);
    const double w363 = lane_max(c[76][l], w362);
    const double w364 = c[11][l] * w363;
    const double w365 = lane_atan(w364);
    const double w366 = c[77][l] * w363;
    const double w367 = c[78][l] * w365;
    const double w368 = w366 + w367;
    const double w369 = c[11][l] * w368;
    const double w370 = lane_atan(w369);
    const double w371 = c[12][l] * w370;
    const double w372 = lane_sin(w371);
    const double w373 = w315 + w355;
    const double w374 = sqrt(w373);
    const double w375 = w372 * w374;
    const double w376 = w375 * w321;
    const double w377 = c[13][l] * w376;
    const double w378 = lane_min(w354, w377);
    const double w379 = -w354;
    const double w380 = lane_max(w379, w378);
    const double w381 = (-100000.0) * w353;
    const double w382 = w381 + 0.5;
    const double w383 = (-100000.0) * w380;
    const double w384 = w382 + w383;
    const double w385 = lane_max(0.0, w384);
    const double w386 = w385 * w385;
    const double w387 = w385 * w386;
    const double w388 = (-0.5) * w385;
    const double w389 = w388 + 1.0;
    const double w390 = w387 * w389;
    const double w391 = 100000.0 * w380;
    const double w392 = w382 + w391;
    const double w393 = lane_max(0.0, w392);
    const double w394 = w393 * w393;
    const double w395 = w393 * w394;
    const double w396 = (-0.5) * w393;
    const double w397 = w396 + 1.0;
    const double w398 = w395 * w397;
    const double w399 = 1e-05 * w390;
    const double w400 = w380 + w399;
    const double w401 = (-1e-05) * w398;
    const double w402 = w400 + w401;
    const double w403 = w182 * w402;
    const double w404 = w403 * w185;
    const double w405 = c[99][l] * x2;
    const double w406 = x1 + w405;
    const double w407 = w406 + w51;
    const double w408 = lane_atan2(w407, w19);
    const double w409 = w408 + c[100][l];
    const double w410 = c[26][l] * w409;
    const double w411 = lane_min(c[97][l], w410);
    const double w412 = lane_max(c[98][l], w411);
    const double w413 = (-5.0) * w412;
    const double w414 = w413 + c[101][l];
    const double w415 = lane_max(0.0, w414);
    const double w416 = w415 * w415;
    const double w417 = w415 * w416;
    const double w418 = (-0.5) * w415;
    const double w419 = w418 + 1.0;
    const double w420 = w417 * w419;
    const double w421 = 5.0 * w412;
    const double w422 = w421 + c[101][l];
    const double w423 = lane_max(0.0, w422);
    const double w424 = w423 * w423;
    const double w425 = w423 * w424;
    const double w426 = (-0.5) * w423;
    const double w427 = w426 + 1.0;
    const double w428 = w425 * w427;
    const double w429 = w407 * w407;
    const double w430 = 0.2 * w420;
    const double w431 = w412 + w430;
    const double w432 = (-0.2) * w428;
    const double w433 = w431 + w432;
    const double w434 = w18 + w429;
    const double w435 = w433 * w434;
    const double w436 = sqrt(w54);
    const double w437 = w436 * x2;
    const double w438 = lane_atan2(w52, w56);
    const double w439 = c[23][l] * w438;
    const double w440 = w439 + c[106][l];
    const double w441 = w54 * w440;
    const double w442 = c[25][l] * w438;
    const double w443 = w442 + c[117][l];
    const double w444 = w54 * w443;
    const double w445 = x0 * w0;
    const double w446 = x1 * w1;
    const double w447 = -w446;
    const double w448 = w445 + w447;
    const double w449 = x0 * w1;
    const double w450 = x1 * w0;
    const double w451 = w449 + w450;
    const double w452 = lane_atan(w251);
    const double w453 = c[10][l] * w239;
    const double w454 = c[10][l] * w297;
    const double w455 = lane_atan(w358);
    const double w456 = c[14][l] * w349;
    const double w457 = c[14][l] * w404;
    const double w458 = lane_atan(w130);
    const double w459 = c[19][l] * w178;
    const double w460 = c[61][l] * w176;
    const double w461 = c[40][l] * w54;
    const double w462 = c[89][l] * w54;
    const double w463 = c[105][l] * w437;
    const double w464 = c[39][l] * w441;
    const double w465 = w463 + w464;
    const double w466 = c[24][l] * w438;
    const double w467 = w466 + c[133][l];
    const double w468 = w54 * w467;
    const double w469 = c[132][l] * w437;
    const double w470 = c[116][l] * w468;
    const double w471 = w469 + w470;
    const double w472 = c[134][l] * w437;
    const double w473 = c[116][l] * w444;
    const double w474 = w472 + w473;
    const double w475 = c[102][l] * w435;
    const double w476 = c[35][l] * w46;
    const double w477 = w451 * w451;
    const double w478 = w448 * w448;
    const double w479 = w477 + 1e-12;
    const double w480 = w479 + w478;
    const double w481 = sqrt(w480);
    const double w482 = c[90][l] * w58;
    const double w483 = w482 + c[2][l];
    const double w484 = c[63][l] * w178;
    const double w485 = w483 + w484;
    const double w486 = c[107][l] * w349;
    const double w487 = w485 + w486;
    const double w488 = c[62][l] * w176;
    const double w489 = w487 + w488;
    const double w490 = -w300;
    const double w491 = w489 + w490;
    const double w492 = c[135][l] * w404;
    const double w493 = w491 + w492;
    const double w494 = c[137][l] * w178;
    const double w495 = w494 + c[3][l];
    const double w496 = c[80][l] * w239;
    const double w497 = w495 + w496;
    const double w498 = c[88][l] * w349;
    const double w499 = w497 + w498;
    const double w500 = c[103][l] * w435;
    const double w501 = w499 + w500;
    const double w502 = w501 + w465;
    const double w503 = c[138][l] * w176;
    const double w504 = w502 + w503;
    const double w505 = c[136][l] * w297;
    const double w506 = w504 + w505;
    const double w507 = c[107][l] * w404;
    const double w508 = w506 + w507;
    const double w509 = c[143][l] * w178;
    const double w510 = w509 + c[119][l];
    const double w511 = c[141][l] * w239;
    const double w512 = w510 + w511;
    const double w513 = c[139][l] * w349;
    const double w514 = w512 + w513;
    const double w515 = c[118][l] * w435;
    const double w516 = w514 + w515;
    const double w517 = w516 + w474;
    const double w518 = c[144][l] * w176;
    const double w519 = w517 + w518;
    const double w520 = c[142][l] * w297;
    const double w521 = w519 + w520;
    const double w522 = c[120][l] * w300;
    const double w523 = w521 + w522;
    const double w524 = c[140][l] * w404;
    const double w525 = w523 + w524;
    const double w526 = c[91][l] * w493;
    const double w527 = c[91][l] * w508;
    const double w528 = c[150][l] * w178;
    const double w529 = w528 + c[145][l];
    const double w530 = c[148][l] * w239;
    const double w531 = w529 + w530;
    const double w532 = c[152][l] * w349;
    const double w533 = w531 + w532;
    const double w534 = c[146][l] * w435;
    const double w535 = w533 + w534;
    const double w536 = -w471;
    const double w537 = w535 + w536;
    const double w538 = c[151][l] * w176;
    const double w539 = w537 + w538;
    const double w540 = c[149][l] * w297;
    const double w541 = w539 + w540;
    const double w542 = c[147][l] * w404;
    const double w543 = w541 + w542;
    const double w544 = -w64;
    const double w545 = c[153][l] * w46;
    const double w546 = w544 + w545;
    const double w547 = c[156][l] * w178;
    const double w548 = w546 + w547;
    const double w549 = c[157][l] * w239;
    const double w550 = w548 + w549;
    const double w551 = c[158][l] * w349;
    const double w552 = w550 + w551;
    const double w553 = c[155][l] * w176;
    const double w554 = w552 + w553;
    const double w555 = c[154][l] * w297;
    const double w556 = w554 + w555;
    const double w557 = c[152][l] * w404;
    const double w558 = w556 + w557;
    const double w559 = w481 + c[159][l];
    const double w560 = fabs(x4);
    const double w561 = w560 + c[160][l];
    const double w562 = fabs(x5);
    const double w563 = w562 + c[161][l];
    *y0 = w182;
    *y1 = w452;
    *y2 = w453;
    *y3 = w454;
    *y4 = w182;
    *y5 = w455;
    *y6 = w456;
    *y7 = w457;
    *y8 = w70;
    *y9 = w458;
    *y10 = w459;
    *y11 = w460;
    *y12 = c[4][l];
    *y13 = w438;
    *y14 = c[37][l];
    *y15 = w461;
    *y16 = w462;
    *y17 = w465;
    *y18 = w471;
    *y19 = w63;
    *y20 = w474;
    *y21 = w408;
    *y22 = w433;
    *y23 = w475;
    *y24 = w22;
    *y25 = w45;
    *y26 = w476;
    *y27 = w481;
    *y28 = w493;
    *y29 = w508;
    *y30 = w525;
    *y31 = w526;
    *y32 = w527;
    *y33 = w62;
    *y34 = w543;
    *y35 = w558;
    *y36 = w559;
    *y37 = w561;
    *y38 = w563;
}

APART void observe_lanes(const lanes *c, const lanes *u, const lanes *x, lanes *y)
{
    LANE_LOOP {
        output(c, l, PICK(x, S0, l), PICK(x, S1, l), PICK(x, S2, l), PICK(x, S4, l), PICK(x, S5, l), &y[0][l], &y[1][l], &y[2][l], &y[3][l], &y[4][l], &y[5][l], &y[6][l], &y[7][l], &y[8][l], &y[9][l], &y[10][l], &y[11][l], &y[12][l], &y[13][l], &y[14][l], &y[15][l], &y[16][l], &y[17][l], &y[18][l], &y[19][l], &y[20][l], &y[21][l], &y[22][l], &y[23][l], &y[24][l], &y[25][l], &y[26][l], &y[27][l], &y[28][l], &y[29][l], &y[30][l], &y[31][l], &y[32][l], &y[33][l], &y[34][l], &y[35][l], &y[36][l], &y[37][l], &y[38][l]);
    }
}

APART void observe_row(const lanes *c, int l, double (*u)[TILE], double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, PICK(x, S0, s), PICK(x, S1, s), PICK(x, S2, s), PICK(x, S4, s), PICK(x, S5, s), &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s], &y[11][s], &y[12][s], &y[13][s], &y[14][s], &y[15][s], &y[16][s], &y[17][s], &y[18][s], &y[19][s], &y[20][s], &y[21][s], &y[22][s], &y[23][s], &y[24][s], &y[25][s], &y[26][s], &y[27][s], &y[28][s], &y[29][s], &y[30][s], &y[31][s], &y[32][s], &y[33][s], &y[34][s], &y[35][s], &y[36][s], &y[37][s], &y[38][s]);
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
    for (int j = 0; j < NU; ++j) {
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
    for (int j = 0; j < NU; ++j)
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
static const double TRUST = 0.5;           /* estimated global error / tol that is accepted */
static const double REACH = 10.5, HOLD = 0.97;  /* see cap() */
static const double GUARD = 0.7;           /* see measure() */
static const double BETWEEN = 0.003;       /* see measure_between() */

/* What is followed of the global error, see below. */
#if PLANE && !VARYING
typedef struct { lanes drift, past[NS], past2[NS], area, passed, spread, shift, doubt, trace; } errors_t;
#else
typedef struct { lanes e[NS], image[NS], mode[ND1], turn[ND1], doubt; } errors_t;
#endif

typedef struct {
    lanes c[NC], x[NS], begin[NS], f0[NS], scale[NS], weight[NS], xn[NS], e5[NS], e3[NS];
    lanes k[DENSE_STAGES][NS], d[DENSE_TERMS][NS], at[NS], y[NY1];
    lanes largest[WATCHES], first[WATCHES], size[WATCHES];
    lanes mode[ND1], growth, rho, reach, t, h, h0, least, tau, error, local, sharp, head, tail;
    lanes steps, state, theta, stop, finish;
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

/* ---- step control ------------------------------------------------------------------------ */

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
            size[l] = larger(size[l], w * fabs(b->mode[j][l]));
            grown[l] = larger(grown[l], w * fabs(turn[j][l]));
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
        LANE_LOOP b->mode[j][l] = size[l] > 0.0 ? turn[j][l] * size[l] : b->mode[j][l];
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
    turns(b->c, b->x, b->mode, b->k[0], turn, b->errors.trace);
    cap(b, turn);
}

/* exp(x), within a fifth for |x| < 3 and bounded beyond. */
INLINE double swell(double x)
{
    const double z = fabs(x), p = 1.0 + z * (1.0 + z * (1.0 / 2 + z * (1.0 / 6 + z / 24)));
    return x < 0.0 ? 1.0 / p : p;
}

static void follow_error(block_t *b, double t_end)
{
    errors_t *e = &b->errors;
    const double rest = REST / t_end;
    LANE_LOOP {
        const double local = b->error[l] <= b->tau[l] ? b->local[l] : 0.0;
        const double head = larger(b->head[l], rest), tail = b->tail[l], per_head = 1.0 / head;
        const double trace = e->trace[l], shift = local * per_head, side = local * head;
        const double grown = swell(0.5 * e->passed[l] * (e->spread[l] + trace));
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
    const double grown = swell(e->passed[l] * e->spread[l]);
    const double across = ACROSS * grown / larger(b->tail[l], REST / t_end);
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
    memcpy(e->mode, b->mode, sizeof e->mode);
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
        scale[l] = h > 0.0 ? b->local[l] / sqrt(b->sharp[l] + DBL_MIN) : 0.0;
    }
    for (int j = 0; j < ND; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->e5[j][l] : 0.0;
            const double moved = own[l] * e->e[j][l] + side[l] * e->mode[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    for (int j = ND; j < NS; ++j)
        LANE_LOOP {
            const double w = b->weight[j][l], add = scale[l] > 0.0 ? scale[l] * b->e5[j][l] : 0.0;
            const double moved = e->e[j][l] + drift[l] * e->image[j][l];
            e->e[j][l] = moved;
            ee[l] += w * moved * w * moved;
            em[l] += w * moved * w * add;
        }
    LANE_LOOP {
        /* the sum points where both do, and is as long as two sides of a right angle */
        const double local = scale[l] > 0.0 ? b->local[l] : 0.0, sum = ee[l] + local * local;
        e->doubt[l] = larger(e->doubt[l], sum);
        own[l] = sqrt(sum / (sum + 2.0 * fabs(em[l]) + DBL_MIN));
        scale[l] = em[l] < 0.0 ? -scale[l] : scale[l];
    }
    for (int j = 0; j < NS; ++j)
        LANE_LOOP {
            const double add = scale[l] != 0.0 ? scale[l] * b->e5[j][l] : 0.0;
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

static void attempt(block_t *b)
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
            b->e5[j][l] = 0.01312004499419488 * b->k[0][j][l] + -1.2251564463762044 * b->k[5][j][l] + -0.4957589496572502 * b->k[6][j][l] + 1.6643771824549864 * b->k[7][j][l] + -0.35032884874997366 * b->k[8][j][l] + 0.3341791187130175 * b->k[9][j][l] + 0.08192320648511571 * b->k[10][j][l] + -0.022355307863886294 * b->k[11][j][l];
            b->e3[j][l] = -0.18980075407240762 * b->k[0][j][l] + 4.450312892752409 * b->k[5][j][l] + 1.8915178993145003 * b->k[6][j][l] + -5.801203960010585 * b->k[7][j][l] + -0.4226823213237919 * b->k[8][j][l] + -0.1521609496625161 * b->k[9][j][l] + 0.20136540080403034 * b->k[10][j][l] + 0.02265179219836082 * b->k[11][j][l];
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
        b->sharp[l] = five[l];
    }
    if (between)
        measure_between(b, tol);
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
#if VARYING
        const double goal = smaller(t_end, b->in.until[l]);
#else
        const double goal = t_end;
#endif
        const double ratio = b->error[l] / b->tau[l];
        const double wish = SAFETY * inverse_eighth_root(smaller(ratio, 1e30) + 1e-30);
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

INLINE double dense(const block_t *b, int j, int l, double s)
{
    const double r = 1.0 - s;
    const double end = b->d[5][j][l] + s * b->d[6][j][l];
    const double inner = b->d[3][j][l] + s * (b->d[4][j][l] + r * end);
    return b->x[j][l] + s * (b->d[0][j][l] + r * (b->d[1][j][l] + s * (b->d[2][j][l] + r * inner)));
}

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
    const double probe = 1e-4 * t_end, ease = 0.5 * pow(tau, 0.125);
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
    if (b->tau[l] != tau)
        b->reach[l] = REACH * pow(tau, 1.0 / 12.0);
    b->tau[l] = tau;
    b->h[l] = h;
    b->t[l] = 0.0;
    b->state[l] = RUNNING;
    b->growth[l] = b->rho[l] = 0.0;
    for (int j = 0; j < ND; ++j)
        b->mode[j][l] = b->f0[j][l];
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
    restart(b, l, job, finer, b->h0[l] * pow(finer / b->tau[l], 0.125));
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
        attempt(&b);
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
