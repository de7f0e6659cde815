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
enum { NC = VARYING ? 242 : 269 };
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
        c[189][l] = w297;
        c[190][l] = w298;
        c[191][l] = w299;
        c[192][l] = w300;
        c[193][l] = w308;
        c[194][l] = w310;
        c[195][l] = w311;
        c[196][l] = w312;
        c[197][l] = w313;
        c[198][l] = w314;
        c[199][l] = w315;
        c[200][l] = w316;
        c[201][l] = w317;
        c[202][l] = w318;
        c[203][l] = w320;
        c[204][l] = w321;
        c[205][l] = w322;
        c[206][l] = w323;
        c[207][l] = w324;
        c[208][l] = w325;
        c[209][l] = w326;
        c[210][l] = w327;
        c[211][l] = w328;
        c[212][l] = w329;
        c[213][l] = w330;
        c[214][l] = w332;
        c[215][l] = w333;
        c[216][l] = w335;
        c[217][l] = w343;
        c[218][l] = w344;
        c[219][l] = w348;
        c[220][l] = w349;
        c[221][l] = w350;
        c[222][l] = w352;
        c[223][l] = w353;
        c[224][l] = w356;
        c[225][l] = w359;
        c[226][l] = w361;
        c[227][l] = w362;
        c[228][l] = w363;
        c[229][l] = w366;
        c[230][l] = w377;
        c[231][l] = w379;
        c[232][l] = w382;
        c[233][l] = w384;
        c[234][l] = w387;
        c[235][l] = w389;
        c[236][l] = w390;
        c[237][l] = w391;
        c[238][l] = w392;
        c[239][l] = w393;
        c[240][l] = w394;
        c[241][l] = w395;
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
    const double w178 = x1 * e2;
    const double w179 = x2 * e1;
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
    const double w190 = w1 * e5;
    const double w191 = u1 * w190;
    const double w192 = w3 * e5;
    const double w193 = u0 * w192;
    const double w194 = -w193;
    const double w195 = w191 + w194;
    const double w196 = -w195;
    const double w197 = e0 + w196;
    const double w198 = w10 * w197;
    const double w199 = w7 * w197;
    const double w200 = 1.0 / w10;
    const double w201 = w199 * w200;
    const double w202 = w7 * w201;
    const double w203 = w198 + w202;
    const double w204 = w189 * w203;
    const double w205 = w184 * w204;
    const double w206 = w17 * w205;
    const double w207 = w16 * w205;
    const double w208 = w16 * w207;
    const double w209 = 1000000.0 * w206;
    const double w210 = 2000000.0 * w208;
    const double w211 = w209 + w210;
    const double w212 = w22 * w211;
    const double w213 = (-8000000.0) * w205;
    const double w214 = 6000000.0 * w207;
    const double w215 = w213 + w214;
    const double w216 = w18 * w215;
    const double w217 = 0.0 <= w24 ? 1.0 : 0.0;
    const double w218 = w24 <= 0.0 ? 1.0 : 0.0;
    const double w219 = w217 + w218;
    const double w220 = 1.0 / w219;
    const double w221 = w217 * w220;
    const double w222 = w221 * w203;
    const double w223 = 1e-06 * w212;
    const double w224 = 1e-06 * w216;
    const double w225 = w223 + w224;
    const double w226 = w225 + w222;
    const double w227 = u1 * w192;
    const double w228 = u0 * w190;
    const double w229 = w227 + w228;
    const double w230 = e1 + w229;
    const double w231 = w38 * w230;
    const double w232 = 2.0 * w199;
    const double w233 = 2.0 * w231;
    const double w234 = w232 + w233;
    const double w235 = w48 * w234;
    const double w236 = c[47][l] * w235;
    const double w237 = w7 * w234;
    const double w238 = w40 * w197;
    const double w239 = c[43][l] * w237;
    const double w240 = c[43][l] * w238;
    const double w241 = w239 + w240;
    const double w242 = w241 * w43;
    const double w243 = w44 * w43;
    const double w244 = w199 * w43;
    const double w245 = w243 * w244;
    const double w246 = c[44][l] * w245;
    const double w247 = w242 + w246;
    const double w248 = c[50][l] * e2;
    const double w249 = e1 + w248;
    const double w250 = c[58][l] * e0;
    const double w251 = c[59][l] * e2;
    const double w252 = w250 + w251;
    const double w253 = c[56][l] * w249;
    const double w254 = w252 + w253;
    const double w255 = w254 * w72;
    const double w256 = w73 * w72;
    const double w257 = w59 * w254;
    const double w258 = c[61][l] * e0;
    const double w259 = c[62][l] * e2;
    const double w260 = w258 + w259;
    const double w261 = c[58][l] * w249;
    const double w262 = w260 + w261;
    const double w263 = w65 * w262;
    const double w264 = 2.0 * w257;
    const double w265 = 2.0 * w263;
    const double w266 = w264 + w265;
    const double w267 = w67 * w266;
    const double w268 = w267 * w80;
    const double w269 = w268 * w72;
    const double w270 = w256 * w269;
    const double w271 = (-0.5) * w270;
    const double w272 = w255 + w271;
    const double w273 = w262 * w76;
    const double w274 = w77 * w76;
    const double w275 = w257 * w76;
    const double w276 = w274 * w275;
    const double w277 = -w276;
    const double w278 = w273 + w277;
    const double w279 = 1.0 / w79;
    const double w280 = w266 * w279;
    const double w281 = w263 * w80;
    const double w282 = w81 * w80;
    const double w283 = w282 * w268;
    const double w284 = 2.0 * w281;
    const double w285 = -w283;
    const double w286 = w284 + w285;
    const double w287 = c[74][l] * e2;
    const double w288 = w250 + w287;
    const double w289 = c[61][l] * w249;
    const double w290 = w288 + w289;
    const double w291 = w290 * w101;
    const double w292 = w102 * w101;
    const double w293 = w89 * w290;
    const double w294 = c[56][l] * e0;
    const double w295 = c[75][l] * e2;
    const double w296 = w294 + w295;
    const double w297 = w296 + w261;
    const double w298 = w94 * w297;
    const double w299 = 2.0 * w293;
    const double w300 = 2.0 * w298;
    const double w301 = w299 + w300;
    const double w302 = w96 * w301;
    const double w303 = w302 * w109;
    const double w304 = w303 * w101;
    const double w305 = w292 * w304;
    const double w306 = (-0.5) * w305;
    const double w307 = w291 + w306;
    const double w308 = w297 * w105;
    const double w309 = w106 * w105;
    const double w310 = w293 * w105;
    const double w311 = w309 * w310;
    const double w312 = -w311;
    const double w313 = w308 + w312;
    const double w314 = 1.0 / w108;
    const double w315 = w301 * w314;
    const double w316 = w298 * w109;
    const double w317 = w110 * w109;
    const double w318 = w317 * w303;
    const double w319 = 2.0 * w316;
    const double w320 = -w318;
    const double w321 = w319 + w320;
    const double w322 = w118 * e0;
    const double w323 = c[45][l] * e2;
    const double w324 = e1 + w323;
    const double w325 = w122 * w324;
    const double w326 = w322 + w325;
    const double w327 = w326 * w136;
    const double w328 = w137 * w136;
    const double w329 = w124 * w326;
    const double w330 = w118 * w324;
    const double w331 = w122 * e0;
    const double w332 = -w331;
    const double w333 = w330 + w332;
    const double w334 = w129 * w333;
    const double w335 = 2.0 * w329;
    const double w336 = 2.0 * w334;
    const double w337 = w335 + w336;
    const double w338 = w131 * w337;
    const double w339 = 1.0 / w134;
    const double w340 = w338 * w339;
    const double w341 = w340 * w136;
    const double w342 = w328 * w341;
    const double w343 = (-0.5) * w342;
    const double w344 = w327 + w343;
    const double w345 = w333 * w140;
    const double w346 = w141 * w140;
    const double w347 = w329 * w140;
    const double w348 = w346 * w347;
    const double w349 = -w348;
    const double w350 = w345 + w349;
    const double w351 = 1.0 / w143;
    const double w352 = w337 * w351;
    const double w353 = c[89][l] * w237;
    const double w354 = c[89][l] * w238;
    const double w355 = w353 + w354;
    const double w356 = w355 * w43;
    const double w357 = w178 + w179;
    const double w358 = c[167][l] * w245;
    const double w359 = w357 + w358;
    const double w360 = c[92][l] * w356;
    const double w361 = w359 + w360;
    const double w362 = 1.0 / w156;
    const double w363 = w234 * w362;
    const double w364 = x2 * w363;
    const double w365 = w156 * e2;
    const double w366 = c[168][l] * w364;
    const double w367 = c[105][l] * w365;
    const double w368 = w366 + w367;
    const double w369 = 1.0 / w40;
    const double w370 = w42 * w369;
    const double w371 = w370 * w230;
    const double w372 = w38 * w369;
    const double w373 = w372 * w244;
    const double w374 = -w373;
    const double w375 = w371 + w374;
    const double w376 = w40 * w375;
    const double w377 = 1.0 / w155;
    const double w378 = w29 * w377;
    const double w379 = c[99][l] * e2;
    const double w380 = e1 + w379;
    const double w381 = w380 + w229;
    const double w382 = w378 * w381;
    const double w383 = w150 * w377;
    const double w384 = 1.0 / w29;
    const double w385 = w226 * w384;
    const double w386 = w383 * w385;
    const double w387 = (-0.5) * w386;
    const double w388 = w382 + w387;
    const double w389 = w150 * w381;
    const double w390 = 2.0 * w389;
    const double w391 = w226 + w390;
    const double w392 = x0 * e2;
    const double w393 = x2 * e0;
    const double w394 = -w392;
    const double w395 = -w393;
    const double w396 = w394 + w395;
    const double w397 = c[173][l] * w368;
    const double w398 = w396 + w397;
    const double w399 = c[174][l] * w376;
    const double w400 = w398 + w399;
    const double w401 = c[175][l] * w368;
    const double w402 = c[176][l] * w376;
    const double w403 = w401 + w402;
    const double w404 = w1 * e0;
    const double w405 = x0 * w192;
    const double w406 = w3 * e1;
    const double w407 = x1 * w190;
    const double w408 = -w405;
    const double w409 = w404 + w408;
    const double w410 = -w406;
    const double w411 = w409 + w410;
    const double w412 = -w407;
    const double w413 = w411 + w412;
    const double w414 = w3 * e0;
    const double w415 = x0 * w190;
    const double w416 = w1 * e1;
    const double w417 = x1 * w192;
    const double w418 = w414 + w415;
    const double w419 = w418 + w416;
    const double w420 = -w417;
    const double w421 = w419 + w420;
    const double w422 = x1 * m2;
    const double w423 = x2 * m1;
    const double w424 = w1 * m5;
    const double w425 = u1 * w424;
    const double w426 = w3 * m5;
    const double w427 = u0 * w426;
    const double w428 = -w427;
    const double w429 = w425 + w428;
    const double w430 = -w429;
    const double w431 = m0 + w430;
    const double w432 = w10 * w431;
    const double w433 = w7 * w431;
    const double w434 = w433 * w200;
    const double w435 = w7 * w434;
    const double w436 = w432 + w435;
    const double w437 = w189 * w436;
    const double w438 = w184 * w437;
    const double w439 = w17 * w438;
    const double w440 = w16 * w438;
    const double w441 = w16 * w440;
    const double w442 = 1000000.0 * w439;
    const double w443 = 2000000.0 * w441;
    const double w444 = w442 + w443;
    const double w445 = w22 * w444;
    const double w446 = (-8000000.0) * w438;
    const double w447 = 6000000.0 * w440;
    const double w448 = w446 + w447;
    const double w449 = w18 * w448;
    const double w450 = w221 * w436;
    const double w451 = 1e-06 * w445;
    const double w452 = 1e-06 * w449;
    const double w453 = w451 + w452;
    const double w454 = w453 + w450;
    const double w455 = u1 * w426;
    const double w456 = u0 * w424;
    const double w457 = w455 + w456;
    const double w458 = m1 + w457;
    const double w459 = w38 * w458;
    const double w460 = 2.0 * w433;
    const double w461 = 2.0 * w459;
    const double w462 = w460 + w461;
    const double w463 = w48 * w462;
    const double w464 = c[47][l] * w463;
    const double w465 = w7 * w462;
    const double w466 = w40 * w431;
    const double w467 = c[43][l] * w465;
    const double w468 = c[43][l] * w466;
    const double w469 = w467 + w468;
    const double w470 = w469 * w43;
    const double w471 = w433 * w43;
    const double w472 = w243 * w471;
    const double w473 = c[44][l] * w472;
    const double w474 = w470 + w473;
    const double w475 = c[50][l] * m2;
    const double w476 = m1 + w475;
    const double w477 = c[58][l] * m0;
    const double w478 = c[59][l] * m2;
    const double w479 = w477 + w478;
    const double w480 = c[56][l] * w476;
    const double w481 = w479 + w480;
    const double w482 = w481 * w72;
    const double w483 = w59 * w481;
    const double w484 = c[61][l] * m0;
    const double w485 = c[62][l] * m2;
    const double w486 = w484 + w485;
    const double w487 = c[58][l] * w476;
    const double w488 = w486 + w487;
    const double w489 = w65 * w488;
    const double w490 = 2.0 * w483;
    const double w491 = 2.0 * w489;
    const double w492 = w490 + w491;
    const double w493 = w67 * w492;
    const double w494 = w493 * w80;
    const double w495 = w494 * w72;
    const double w496 = w256 * w495;
    const double w497 = (-0.5) * w496;
    const double w498 = w482 + w497;
    const double w499 = w488 * w76;
    const double w500 = w483 * w76;
    const double w501 = w274 * w500;
    const double w502 = -w501;
    const double w503 = w499 + w502;
    const double w504 = w492 * w279;
    const double w505 = w489 * w80;
    const double w506 = w282 * w494;
    const double w507 = 2.0 * w505;
    const double w508 = -w506;
    const double w509 = w507 + w508;
    const double w510 = c[74][l] * m2;
    const double w511 = w477 + w510;
    const double w512 = c[61][l] * w476;
    const double w513 = w511 + w512;
    const double w514 = w513 * w101;
    const double w515 = w89 * w513;
    const double w516 = c[56][l] * m0;
    const double w517 = c[75][l] * m2;
    const double w518 = w516 + w517;
    const double w519 = w518 + w487;
    const double w520 = w94 * w519;
    const double w521 = 2.0 * w515;
    const double w522 = 2.0 * w520;
    const double w523 = w521 + w522;
    const double w524 = w96 * w523;
    const double w525 = w524 * w109;
    const double w526 = w525 * w101;
    const double w527 = w292 * w526;
    const double w528 = (-0.5) * w527;
    const double w529 = w514 + w528;
    const double w530 = w519 * w105;
    const double w531 = w515 * w105;
    const double w532 = w309 * w531;
    const double w533 = -w532;
    const double w534 = w530 + w533;
    const double w535 = w523 * w314;
    const double w536 = w520 * w109;
    const double w537 = w317 * w525;
    const double w538 = 2.0 * w536;
    const double w539 = -w537;
    const double w540 = w538 + w539;
    const double w541 = w118 * m0;
    const double w542 = c[45][l] * m2;
    const double w543 = m1 + w542;
    const double w544 = w122 * w543;
    const double w545 = w541 + w544;
    const double w546 = w545 * w136;
    const double w547 = w124 * w545;
    const double w548 = w118 * w543;
    const double w549 = w122 * m0;
    const double w550 = -w549;
    const double w551 = w548 + w550;
    const double w552 = w129 * w551;
    const double w553 = 2.0 * w547;
    const double w554 = 2.0 * w552;
    const double w555 = w553 + w554;
    const double w556 = w131 * w555;
    const double w557 = w556 * w339;
    const double w558 = w557 * w136;
    const double w559 = w328 * w558;
    const double w560 = (-0.5) * w559;
    const double w561 = w546 + w560;
    const double w562 = w551 * w140;
    const double w563 = w547 * w140;
    const double w564 = w346 * w563;
    const double w565 = -w564;
    const double w566 = w562 + w565;
    const double w567 = w555 * w351;
    const double w568 = c[89][l] * w465;
    const double w569 = c[89][l] * w466;
    const double w570 = w568 + w569;
    const double w571 = w570 * w43;
    const double w572 = w422 + w423;
    const double w573 = c[167][l] * w472;
    const double w574 = w572 + w573;
    const double w575 = c[92][l] * w571;
    const double w576 = w574 + w575;
    const double w577 = w462 * w362;
    const double w578 = x2 * w577;
    const double w579 = w156 * m2;
    const double w580 = c[168][l] * w578;
    const double w581 = c[105][l] * w579;
    const double w582 = w580 + w581;
    const double w583 = w370 * w458;
    const double w584 = w372 * w471;
    const double w585 = -w584;
    const double w586 = w583 + w585;
    const double w587 = w40 * w586;
    const double w588 = c[99][l] * m2;
    const double w589 = m1 + w588;
    const double w590 = w589 + w457;
    const double w591 = w378 * w590;
    const double w592 = w454 * w384;
    const double w593 = w383 * w592;
    const double w594 = (-0.5) * w593;
    const double w595 = w591 + w594;
    const double w596 = w150 * w590;
    const double w597 = 2.0 * w596;
    const double w598 = w454 + w597;
    const double w599 = x0 * m2;
    const double w600 = x2 * m0;
    const double w601 = -w599;
    const double w602 = -w600;
    const double w603 = w601 + w602;
    const double w604 = c[173][l] * w582;
    const double w605 = w603 + w604;
    const double w606 = c[174][l] * w587;
    const double w607 = w605 + w606;
    const double w608 = c[175][l] * w582;
    const double w609 = c[176][l] * w587;
    const double w610 = w608 + w609;
    const double w611 = w1 * m0;
    const double w612 = x0 * w426;
    const double w613 = w3 * m1;
    const double w614 = x1 * w424;
    const double w615 = -w612;
    const double w616 = w611 + w615;
    const double w617 = -w613;
    const double w618 = w616 + w617;
    const double w619 = -w614;
    const double w620 = w618 + w619;
    const double w621 = w3 * m0;
    const double w622 = x0 * w424;
    const double w623 = w1 * m1;
    const double w624 = x1 * w426;
    const double w625 = w621 + w622;
    const double w626 = w625 + w623;
    const double w627 = -w624;
    const double w628 = w626 + w627;
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
    w[73][l] = w226;
    w[74][l] = w234;
    w[75][l] = w236;
    w[76][l] = w247;
    w[79][l] = w262;
    w[80][l] = w268;
    w[81][l] = w269;
    w[82][l] = w272;
    w[84][l] = w278;
    w[87][l] = w280;
    w[88][l] = w286;
    w[92][l] = w297;
    w[93][l] = w303;
    w[94][l] = w304;
    w[95][l] = w307;
    w[97][l] = w313;
    w[100][l] = w315;
    w[101][l] = w321;
    w[107][l] = w341;
    w[108][l] = w344;
    w[110][l] = w350;
    w[113][l] = w352;
    w[116][l] = w361;
    w[118][l] = w388;
    w[119][l] = w391;
    w[123][l] = w400;
    w[125][l] = w403;
    w[127][l] = w454;
    w[128][l] = w462;
    w[129][l] = w464;
    w[130][l] = w474;
    w[133][l] = w488;
    w[134][l] = w494;
    w[135][l] = w495;
    w[136][l] = w498;
    w[138][l] = w503;
    w[141][l] = w504;
    w[142][l] = w509;
    w[146][l] = w519;
    w[147][l] = w525;
    w[148][l] = w526;
    w[149][l] = w529;
    w[151][l] = w534;
    w[154][l] = w535;
    w[155][l] = w540;
    w[161][l] = w558;
    w[162][l] = w561;
    w[164][l] = w566;
    w[167][l] = w567;
    w[170][l] = w576;
    w[172][l] = w595;
    w[173][l] = w598;
    w[177][l] = w607;
    w[179][l] = w610;
    WRITE(f, S3, w174);
    WRITE(f, S4, w177);
    WRITE(f, S5, x2);
    WRITE(r, S3, w413);
    WRITE(r, S4, w421);
    WRITE(r, S5, e2);
    WRITE_MOVING(g, S3, w620);
    WRITE_MOVING(g, S4, w628);
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
    const double w245 = w47 <= w46 ? 1.0 : 0.0;
    const double w246 = w46 <= w47 ? 1.0 : 0.0;
    const double w247 = w245 + w246;
    const double w248 = 1.0 / w247;
    const double w249 = w245 * w248;
    const double w250 = w45 <= w[12][l] ? 1.0 : 0.0;
    const double w251 = w[12][l] <= w45 ? 1.0 : 0.0;
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
    const double w266 = w25 * w[73][l];
    const double w267 = c[46][l] * w266;
    const double w268 = w[75][l] + w267;
    const double w269 = c[39][l] * w266;
    const double w270 = w[76][l] + w269;
    const double w271 = c[51][l] * w270;
    const double w272 = w268 + w271;
    const double w273 = w265 * w272;
    const double w274 = w260 * w273;
    const double w275 = w255 * w274;
    const double w276 = u4 * w274;
    const double w277 = w276 * w41;
    const double w278 = c[139][l] * w275;
    const double w279 = c[140][l] * w277;
    const double w280 = w278 + w279;
    const double w281 = w254 * w280;
    const double w282 = w251 * w253;
    const double w283 = w282 * w[82][l];
    const double w284 = w281 + w283;
    const double w285 = w249 * w284;
    const double w286 = w246 * w248;
    const double w287 = w286 * w280;
    const double w288 = -w287;
    const double w289 = w285 + w288;
    const double w290 = 0.0 <= w52 ? 1.0 : 0.0;
    const double w291 = w52 <= 0.0 ? 1.0 : 0.0;
    const double w292 = w290 + w291;
    const double w293 = 1.0 / w292;
    const double w294 = w290 * w293;
    const double w295 = (-100000.0) * w280;
    const double w296 = (-100000.0) * w289;
    const double w297 = w295 + w296;
    const double w298 = w294 * w297;
    const double w299 = w54 * w298;
    const double w300 = w53 * w298;
    const double w301 = w53 * w300;
    const double w302 = 2.0 * w301;
    const double w303 = w299 + w302;
    const double w304 = w57 * w303;
    const double w305 = w55 * w298;
    const double w306 = 0.0 <= w60 ? 1.0 : 0.0;
    const double w307 = w60 <= 0.0 ? 1.0 : 0.0;
    const double w308 = w306 + w307;
    const double w309 = 1.0 / w308;
    const double w310 = w306 * w309;
    const double w311 = 100000.0 * w289;
    const double w312 = w295 + w311;
    const double w313 = w310 * w312;
    const double w314 = w62 * w313;
    const double w315 = w61 * w313;
    const double w316 = w61 * w315;
    const double w317 = 2.0 * w316;
    const double w318 = w314 + w317;
    const double w319 = w65 * w318;
    const double w320 = w63 * w313;
    const double w321 = 1e-05 * w304;
    const double w322 = w289 + w321;
    const double w323 = (-5e-06) * w305;
    const double w324 = w322 + w323;
    const double w325 = (-1e-05) * w319;
    const double w326 = w324 + w325;
    const double w327 = 5e-06 * w320;
    const double w328 = w326 + w327;
    const double w329 = w70 * w328;
    const double w330 = 1.0 / w74;
    const double w331 = w329 * w330;
    const double w332 = c[65][l] <= w82 ? 1.0 : 0.0;
    const double w333 = w82 <= c[65][l] ? 1.0 : 0.0;
    const double w334 = w332 + w333;
    const double w335 = 1.0 / w334;
    const double w336 = w332 * w335;
    const double w337 = w81 <= c[64][l] ? 1.0 : 0.0;
    const double w338 = c[64][l] <= w81 ? 1.0 : 0.0;
    const double w339 = w337 + w338;
    const double w340 = 1.0 / w339;
    const double w341 = w337 * w340;
    const double w342 = w78 * w[84][l];
    const double w343 = 0.0 <= w77 ? 1.0 : 0.0;
    const double w344 = w77 <= 0.0 ? 1.0 : 0.0;
    const double w345 = w343 + w344;
    const double w346 = 1.0 / w345;
    const double w347 = w343 * w346;
    const double w348 = w347 * w273;
    const double w349 = w[14][l] * w348;
    const double w350 = c[142][l] * w349;
    const double w351 = w342 + w350;
    const double w352 = w351 * w41;
    const double w353 = w80 * w41;
    const double w354 = w353 * w274;
    const double w355 = c[55][l] * w352;
    const double w356 = c[139][l] * w354;
    const double w357 = w355 + w356;
    const double w358 = w341 * w357;
    const double w359 = w336 * w358;
    const double w360 = w83 * w83;
    const double w361 = c[143][l] * w360;
    const double w362 = w361 + 1.0;
    const double w363 = 1.0 / w362;
    const double w364 = w359 * w363;
    const double w365 = c[67][l] * w359;
    const double w366 = c[144][l] * w364;
    const double w367 = w365 + w366;
    const double w368 = (-100000.0) * w331;
    const double w369 = 100000.0 * w331;
    const double w370 = w34 * w328;
    const double w371 = w70 * w273;
    const double w372 = c[53][l] * w371;
    const double w373 = w370 + w372;
    const double w374 = w37 * w373;
    const double w375 = w89 * w274;
    const double w376 = c[8][l] * w374;
    const double w377 = c[149][l] * w375;
    const double w378 = w376 + w377;
    const double w379 = c[150][l] * w378;
    const double w380 = w100 <= w99 ? 1.0 : 0.0;
    const double w381 = w99 <= w100 ? 1.0 : 0.0;
    const double w382 = w380 + w381;
    const double w383 = 1.0 / w382;
    const double w384 = w380 * w383;
    const double w385 = w98 <= w[29][l] ? 1.0 : 0.0;
    const double w386 = w[29][l] <= w98 ? 1.0 : 0.0;
    const double w387 = w385 + w386;
    const double w388 = 1.0 / w387;
    const double w389 = w385 * w388;
    const double w390 = w96 * w41;
    const double w391 = w390 * w274;
    const double w392 = u5 * w274;
    const double w393 = w392 * w41;
    const double w394 = c[151][l] * w391;
    const double w395 = c[152][l] * w393;
    const double w396 = w394 + w395;
    const double w397 = w389 * w396;
    const double w398 = w386 * w388;
    const double w399 = w398 * w[95][l];
    const double w400 = w397 + w399;
    const double w401 = w384 * w400;
    const double w402 = w381 * w383;
    const double w403 = w402 * w396;
    const double w404 = -w403;
    const double w405 = w401 + w404;
    const double w406 = 0.0 <= w105 ? 1.0 : 0.0;
    const double w407 = w105 <= 0.0 ? 1.0 : 0.0;
    const double w408 = w406 + w407;
    const double w409 = 1.0 / w408;
    const double w410 = w406 * w409;
    const double w411 = (-100000.0) * w396;
    const double w412 = (-100000.0) * w405;
    const double w413 = w411 + w412;
    const double w414 = w410 * w413;
    const double w415 = w107 * w414;
    const double w416 = w106 * w414;
    const double w417 = w106 * w416;
    const double w418 = 2.0 * w417;
    const double w419 = w415 + w418;
    const double w420 = w110 * w419;
    const double w421 = w108 * w414;
    const double w422 = 0.0 <= w113 ? 1.0 : 0.0;
    const double w423 = w113 <= 0.0 ? 1.0 : 0.0;
    const double w424 = w422 + w423;
    const double w425 = 1.0 / w424;
    const double w426 = w422 * w425;
    const double w427 = 100000.0 * w405;
    const double w428 = w411 + w427;
    const double w429 = w426 * w428;
    const double w430 = w115 * w429;
    const double w431 = w114 * w429;
    const double w432 = w114 * w431;
    const double w433 = 2.0 * w432;
    const double w434 = w430 + w433;
    const double w435 = w118 * w434;
    const double w436 = w116 * w429;
    const double w437 = 1e-05 * w420;
    const double w438 = w405 + w437;
    const double w439 = (-5e-06) * w421;
    const double w440 = w438 + w439;
    const double w441 = (-1e-05) * w435;
    const double w442 = w440 + w441;
    const double w443 = 5e-06 * w436;
    const double w444 = w442 + w443;
    const double w445 = w34 * w444;
    const double w446 = w123 * w273;
    const double w447 = c[53][l] * w446;
    const double w448 = w445 + w447;
    const double w449 = w37 * w448;
    const double w450 = w124 * w274;
    const double w451 = c[13][l] * w449;
    const double w452 = c[153][l] * w450;
    const double w453 = w451 + w452;
    const double w454 = w123 * w444;
    const double w455 = 1.0 / w129;
    const double w456 = w454 * w455;
    const double w457 = c[65][l] <= w134 ? 1.0 : 0.0;
    const double w458 = w134 <= c[65][l] ? 1.0 : 0.0;
    const double w459 = w457 + w458;
    const double w460 = 1.0 / w459;
    const double w461 = w457 * w460;
    const double w462 = w133 <= c[64][l] ? 1.0 : 0.0;
    const double w463 = c[64][l] <= w133 ? 1.0 : 0.0;
    const double w464 = w462 + w463;
    const double w465 = 1.0 / w464;
    const double w466 = w462 * w465;
    const double w467 = w78 * w[97][l];
    const double w468 = w[31][l] * w348;
    const double w469 = c[142][l] * w468;
    const double w470 = w467 + w469;
    const double w471 = w470 * w41;
    const double w472 = w132 * w41;
    const double w473 = w472 * w274;
    const double w474 = c[73][l] * w471;
    const double w475 = c[151][l] * w473;
    const double w476 = w474 + w475;
    const double w477 = w466 * w476;
    const double w478 = w461 * w477;
    const double w479 = w135 * w135;
    const double w480 = c[143][l] * w479;
    const double w481 = w480 + 1.0;
    const double w482 = 1.0 / w481;
    const double w483 = w478 * w482;
    const double w484 = c[67][l] * w478;
    const double w485 = c[144][l] * w483;
    const double w486 = w484 + w485;
    const double w487 = (-100000.0) * w456;
    const double w488 = 100000.0 * w456;
    const double w489 = c[58][l] * w453;
    const double w490 = 0.0 <= w144 ? 1.0 : 0.0;
    const double w491 = w144 <= 0.0 ? 1.0 : 0.0;
    const double w492 = w490 + w491;
    const double w493 = 1.0 / w492;
    const double w494 = w490 * w493;
    const double w495 = c[113][l] * w270;
    const double w496 = w268 + w495;
    const double w497 = w494 * w496;
    const double w498 = w152 <= w153 ? 1.0 : 0.0;
    const double w499 = w153 <= w152 ? 1.0 : 0.0;
    const double w500 = w498 + w499;
    const double w501 = 1.0 / w500;
    const double w502 = w498 * w501;
    const double w503 = w149 * w149;
    const double w504 = 0.001 <= w147 ? 1.0 : 0.0;
    const double w505 = w147 <= 0.001 ? 1.0 : 0.0;
    const double w506 = w504 + w505;
    const double w507 = 1.0 / w506;
    const double w508 = w504 * w507;
    const double w509 = w508 * w497;
    const double w510 = w503 * w509;
    const double w511 = w502 * w510;
    const double w512 = w499 * w501;
    const double w513 = w[49][l] <= w151 ? 1.0 : 0.0;
    const double w514 = w151 <= w[49][l] ? 1.0 : 0.0;
    const double w515 = w513 + w514;
    const double w516 = 1.0 / w515;
    const double w517 = w513 * w516;
    const double w518 = w517 * w[108][l];
    const double w519 = w514 * w516;
    const double w520 = w519 * w510;
    const double w521 = c[156][l] * w520;
    const double w522 = w518 + w521;
    const double w523 = w512 * w522;
    const double w524 = c[155][l] * w511;
    const double w525 = w524 + w523;
    const double w526 = 0.0 <= w158 ? 1.0 : 0.0;
    const double w527 = w158 <= 0.0 ? 1.0 : 0.0;
    const double w528 = w526 + w527;
    const double w529 = 1.0 / w528;
    const double w530 = w526 * w529;
    const double w531 = c[157][l] * w510;
    const double w532 = 100000.0 * w525;
    const double w533 = w531 + w532;
    const double w534 = w530 * w533;
    const double w535 = w161 * w534;
    const double w536 = w160 * w534;
    const double w537 = w159 * w534;
    const double w538 = w159 * w537;
    const double w539 = 2.0 * w538;
    const double w540 = w536 + w539;
    const double w541 = w163 * w540;
    const double w542 = 0.0 <= w166 ? 1.0 : 0.0;
    const double w543 = w166 <= 0.0 ? 1.0 : 0.0;
    const double w544 = w542 + w543;
    const double w545 = 1.0 / w544;
    const double w546 = w542 * w545;
    const double w547 = c[158][l] * w510;
    const double w548 = w547 + w532;
    const double w549 = w546 * w548;
    const double w550 = w168 * w549;
    const double w551 = w167 * w549;
    const double w552 = w167 * w551;
    const double w553 = 2.0 * w552;
    const double w554 = w550 + w553;
    const double w555 = w171 * w554;
    const double w556 = w169 * w549;
    const double w557 = 5e-06 * w535;
    const double w558 = w525 + w557;
    const double w559 = (-1e-05) * w541;
    const double w560 = w558 + w559;
    const double w561 = (-1e-05) * w555;
    const double w562 = w560 + w561;
    const double w563 = 5e-06 * w556;
    const double w564 = w562 + w563;
    const double w565 = w176 * w564;
    const double w566 = 1.0 / w180;
    const double w567 = w565 * w566;
    const double w568 = c[84][l] <= w188 ? 1.0 : 0.0;
    const double w569 = w188 <= c[84][l] ? 1.0 : 0.0;
    const double w570 = w568 + w569;
    const double w571 = 1.0 / w570;
    const double w572 = w568 * w571;
    const double w573 = w187 <= c[83][l] ? 1.0 : 0.0;
    const double w574 = c[83][l] <= w187 ? 1.0 : 0.0;
    const double w575 = w573 + w574;
    const double w576 = 1.0 / w575;
    const double w577 = w573 * w576;
    const double w578 = 0.0 <= w183 ? 1.0 : 0.0;
    const double w579 = w183 <= 0.0 ? 1.0 : 0.0;
    const double w580 = w578 + w579;
    const double w581 = 1.0 / w580;
    const double w582 = w578 * w581;
    const double w583 = w582 * w497;
    const double w584 = w[51][l] * w583;
    const double w585 = w184 * w[110][l];
    const double w586 = c[159][l] * w584;
    const double w587 = w586 + w585;
    const double w588 = w587 * w149;
    const double w589 = w186 * w149;
    const double w590 = w589 * w509;
    const double w591 = c[79][l] * w588;
    const double w592 = c[160][l] * w590;
    const double w593 = w591 + w592;
    const double w594 = w577 * w593;
    const double w595 = w572 * w594;
    const double w596 = w189 * w189;
    const double w597 = c[161][l] * w596;
    const double w598 = w597 + 1.0;
    const double w599 = 1.0 / w598;
    const double w600 = w595 * w599;
    const double w601 = c[86][l] * w595;
    const double w602 = c[162][l] * w600;
    const double w603 = w601 + w602;
    const double w604 = (-100000.0) * w567;
    const double w605 = 100000.0 * w567;
    const double w606 = w176 * w497;
    const double w607 = w145 * w564;
    const double w608 = c[52][l] * w606;
    const double w609 = w608 + w607;
    const double w610 = w148 * w609;
    const double w611 = w195 * w509;
    const double w612 = c[20][l] * w610;
    const double w613 = c[154][l] * w611;
    const double w614 = w612 + w613;
    const double w615 = w[46][l] * w614;
    const double w616 = c[92][l] * w615;
    const double w617 = w[116][l] + w616;
    const double w618 = w228 * w[74][l];
    const double w619 = c[97][l] <= w203 ? 1.0 : 0.0;
    const double w620 = w203 <= c[97][l] ? 1.0 : 0.0;
    const double w621 = w619 + w620;
    const double w622 = 1.0 / w621;
    const double w623 = w619 * w622;
    const double w624 = w202 <= c[96][l] ? 1.0 : 0.0;
    const double w625 = c[96][l] <= w202 ? 1.0 : 0.0;
    const double w626 = w624 + w625;
    const double w627 = 1.0 / w626;
    const double w628 = w624 * w627;
    const double w629 = w628 * w[118][l];
    const double w630 = w623 * w629;
    const double w631 = 0.0 <= w206 ? 1.0 : 0.0;
    const double w632 = w206 <= 0.0 ? 1.0 : 0.0;
    const double w633 = w631 + w632;
    const double w634 = 1.0 / w633;
    const double w635 = w631 * w634;
    const double w636 = w635 * w630;
    const double w637 = w209 * w636;
    const double w638 = w208 * w636;
    const double w639 = w207 * w636;
    const double w640 = w207 * w639;
    const double w641 = c[169][l] * w638;
    const double w642 = c[171][l] * w640;
    const double w643 = w641 + w642;
    const double w644 = w211 * w643;
    const double w645 = 0.0 <= w214 ? 1.0 : 0.0;
    const double w646 = w214 <= 0.0 ? 1.0 : 0.0;
    const double w647 = w645 + w646;
    const double w648 = 1.0 / w647;
    const double w649 = w645 * w648;
    const double w650 = w649 * w630;
    const double w651 = w216 * w650;
    const double w652 = w215 * w650;
    const double w653 = w215 * w652;
    const double w654 = c[169][l] * w651;
    const double w655 = c[171][l] * w653;
    const double w656 = w654 + w655;
    const double w657 = w219 * w656;
    const double w658 = w217 * w650;
    const double w659 = c[31][l] * w630;
    const double w660 = c[170][l] * w637;
    const double w661 = w659 + w660;
    const double w662 = (-0.2) * w644;
    const double w663 = w661 + w662;
    const double w664 = (-0.2) * w657;
    const double w665 = w663 + w664;
    const double w666 = c[172][l] * w658;
    const double w667 = w665 + w666;
    const double w668 = w[63][l] * w667;
    const double w669 = w224 * w[119][l];
    const double w670 = c[103][l] * w668;
    const double w671 = c[103][l] * w669;
    const double w672 = w670 + w671;
    const double w673 = c[56][l] * w378;
    const double w674 = c[56][l] * w453;
    const double w675 = w[47][l] * w614;
    const double w676 = c[110][l] * w618;
    const double w677 = w[123][l] + w676;
    const double w678 = c[92][l] * w672;
    const double w679 = w677 + w678;
    const double w680 = w239 * w[74][l];
    const double w681 = c[177][l] * w672;
    const double w682 = w[125][l] + w681;
    const double w683 = c[115][l] * w680;
    const double w684 = w682 + w683;
    const double w685 = w25 * w[127][l];
    const double w686 = c[46][l] * w685;
    const double w687 = w[129][l] + w686;
    const double w688 = c[39][l] * w685;
    const double w689 = w[130][l] + w688;
    const double w690 = c[51][l] * w689;
    const double w691 = w687 + w690;
    const double w692 = w265 * w691;
    const double w693 = w260 * w692;
    const double w694 = w255 * w693;
    const double w695 = u4 * w693;
    const double w696 = w695 * w41;
    const double w697 = c[139][l] * w694;
    const double w698 = c[140][l] * w696;
    const double w699 = w697 + w698;
    const double w700 = w254 * w699;
    const double w701 = w282 * w[136][l];
    const double w702 = w700 + w701;
    const double w703 = w249 * w702;
    const double w704 = w286 * w699;
    const double w705 = -w704;
    const double w706 = w703 + w705;
    const double w707 = (-100000.0) * w699;
    const double w708 = (-100000.0) * w706;
    const double w709 = w707 + w708;
    const double w710 = w294 * w709;
    const double w711 = w54 * w710;
    const double w712 = w53 * w710;
    const double w713 = w53 * w712;
    const double w714 = 2.0 * w713;
    const double w715 = w711 + w714;
    const double w716 = w57 * w715;
    const double w717 = w55 * w710;
    const double w718 = 100000.0 * w706;
    const double w719 = w707 + w718;
    const double w720 = w310 * w719;
    const double w721 = w62 * w720;
    const double w722 = w61 * w720;
    const double w723 = w61 * w722;
    const double w724 = 2.0 * w723;
    const double w725 = w721 + w724;
    const double w726 = w65 * w725;
    const double w727 = w63 * w720;
    const double w728 = 1e-05 * w716;
    const double w729 = w706 + w728;
    const double w730 = (-5e-06) * w717;
    const double w731 = w729 + w730;
    const double w732 = (-1e-05) * w726;
    const double w733 = w731 + w732;
    const double w734 = 5e-06 * w727;
    const double w735 = w733 + w734;
    const double w736 = w70 * w735;
    const double w737 = w736 * w330;
    const double w738 = w78 * w[138][l];
    const double w739 = w347 * w692;
    const double w740 = w[14][l] * w739;
    const double w741 = c[142][l] * w740;
    const double w742 = w738 + w741;
    const double w743 = w742 * w41;
    const double w744 = w353 * w693;
    const double w745 = c[55][l] * w743;
    const double w746 = c[139][l] * w744;
    const double w747 = w745 + w746;
    const double w748 = w341 * w747;
    const double w749 = w336 * w748;
    const double w750 = w749 * w363;
    const double w751 = c[67][l] * w749;
    const double w752 = c[144][l] * w750;
    const double w753 = w751 + w752;
    const double w754 = (-100000.0) * w737;
    const double w755 = 100000.0 * w737;
    const double w756 = w34 * w735;
    const double w757 = w70 * w692;
    const double w758 = c[53][l] * w757;
    const double w759 = w756 + w758;
    const double w760 = w37 * w759;
    const double w761 = w89 * w693;
    const double w762 = c[8][l] * w760;
    const double w763 = c[149][l] * w761;
    const double w764 = w762 + w763;
    const double w765 = c[150][l] * w764;
    const double w766 = w390 * w693;
    const double w767 = u5 * w693;
    const double w768 = w767 * w41;
    const double w769 = c[151][l] * w766;
    const double w770 = c[152][l] * w768;
    const double w771 = w769 + w770;
    const double w772 = w389 * w771;
    const double w773 = w398 * w[149][l];
    const double w774 = w772 + w773;
    const double w775 = w384 * w774;
    const double w776 = w402 * w771;
    const double w777 = -w776;
    const double w778 = w775 + w777;
    const double w779 = (-100000.0) * w771;
    const double w780 = (-100000.0) * w778;
    const double w781 = w779 + w780;
    const double w782 = w410 * w781;
    const double w783 = w107 * w782;
    const double w784 = w106 * w782;
    const double w785 = w106 * w784;
    const double w786 = 2.0 * w785;
    const double w787 = w783 + w786;
    const double w788 = w110 * w787;
    const double w789 = w108 * w782;
    const double w790 = 100000.0 * w778;
    const double w791 = w779 + w790;
    const double w792 = w426 * w791;
    const double w793 = w115 * w792;
    const double w794 = w114 * w792;
    const double w795 = w114 * w794;
    const double w796 = 2.0 * w795;
    const double w797 = w793 + w796;
    const double w798 = w118 * w797;
    const double w799 = w116 * w792;
    const double w800 = 1e-05 * w788;
    const double w801 = w778 + w800;
    const double w802 = (-5e-06) * w789;
    const double w803 = w801 + w802;
    const double w804 = (-1e-05) * w798;
    const double w805 = w803 + w804;
    const double w806 = 5e-06 * w799;
    const double w807 = w805 + w806;
    const double w808 = w34 * w807;
    const double w809 = w123 * w692;
    const double w810 = c[53][l] * w809;
    const double w811 = w808 + w810;
    const double w812 = w37 * w811;
    const double w813 = w124 * w693;
    const double w814 = c[13][l] * w812;
    const double w815 = c[153][l] * w813;
    const double w816 = w814 + w815;
    const double w817 = w123 * w807;
    const double w818 = w817 * w455;
    const double w819 = w78 * w[151][l];
    const double w820 = w[31][l] * w739;
    const double w821 = c[142][l] * w820;
    const double w822 = w819 + w821;
    const double w823 = w822 * w41;
    const double w824 = w472 * w693;
    const double w825 = c[73][l] * w823;
    const double w826 = c[151][l] * w824;
    const double w827 = w825 + w826;
    const double w828 = w466 * w827;
    const double w829 = w461 * w828;
    const double w830 = w829 * w482;
    const double w831 = c[67][l] * w829;
    const double w832 = c[144][l] * w830;
    const double w833 = w831 + w832;
    const double w834 = (-100000.0) * w818;
    const double w835 = 100000.0 * w818;
    const double w836 = c[58][l] * w816;
    const double w837 = c[113][l] * w689;
    const double w838 = w687 + w837;
    const double w839 = w494 * w838;
    const double w840 = w508 * w839;
    const double w841 = w503 * w840;
    const double w842 = w502 * w841;
    const double w843 = w517 * w[162][l];
    const double w844 = w519 * w841;
    const double w845 = c[156][l] * w844;
    const double w846 = w843 + w845;
    const double w847 = w512 * w846;
    const double w848 = c[155][l] * w842;
    const double w849 = w848 + w847;
    const double w850 = c[157][l] * w841;
    const double w851 = 100000.0 * w849;
    const double w852 = w850 + w851;
    const double w853 = w530 * w852;
    const double w854 = w161 * w853;
    const double w855 = w160 * w853;
    const double w856 = w159 * w853;
    const double w857 = w159 * w856;
    const double w858 = 2.0 * w857;
    const double w859 = w855 + w858;
    const double w860 = w163 * w859;
    const double w861 = c[158][l] * w841;
    const double w862 = w861 + w851;
    const double w863 = w546 * w862;
    const double w864 = w168 * w863;
    const double w865 = w167 * w863;
    const double w866 = w167 * w865;
    const double w867 = 2.0 * w866;
    const double w868 = w864 + w867;
    const double w869 = w171 * w868;
    const double w870 = w169 * w863;
    const double w871 = 5e-06 * w854;
    const double w872 = w849 + w871;
    const double w873 = (-1e-05) * w860;
    const double w874 = w872 + w873;
    const double w875 = (-1e-05) * w869;
    const double w876 = w874 + w875;
    const double w877 = 5e-06 * w870;
    const double w878 = w876 + w877;
    const double w879 = w176 * w878;
    const double w880 = w879 * w566;
    const double w881 = w582 * w839;
    const double w882 = w[51][l] * w881;
    const double w883 = w184 * w[164][l];
    const double w884 = c[159][l] * w882;
    const double w885 = w884 + w883;
    const double w886 = w885 * w149;
    const double w887 = w589 * w840;
    const double w888 = c[79][l] * w886;
    const double w889 = c[160][l] * w887;
    const double w890 = w888 + w889;
    const double w891 = w577 * w890;
    const double w892 = w572 * w891;
    const double w893 = w892 * w599;
    const double w894 = c[86][l] * w892;
    const double w895 = c[162][l] * w893;
    const double w896 = w894 + w895;
    const double w897 = (-100000.0) * w880;
    const double w898 = 100000.0 * w880;
    const double w899 = w176 * w839;
    const double w900 = w145 * w878;
    const double w901 = c[52][l] * w899;
    const double w902 = w901 + w900;
    const double w903 = w148 * w902;
    const double w904 = w195 * w840;
    const double w905 = c[20][l] * w903;
    const double w906 = c[154][l] * w904;
    const double w907 = w905 + w906;
    const double w908 = w[46][l] * w907;
    const double w909 = c[92][l] * w908;
    const double w910 = w[170][l] + w909;
    const double w911 = w228 * w[128][l];
    const double w912 = w628 * w[172][l];
    const double w913 = w623 * w912;
    const double w914 = w635 * w913;
    const double w915 = w209 * w914;
    const double w916 = w208 * w914;
    const double w917 = w207 * w914;
    const double w918 = w207 * w917;
    const double w919 = c[169][l] * w916;
    const double w920 = c[171][l] * w918;
    const double w921 = w919 + w920;
    const double w922 = w211 * w921;
    const double w923 = w649 * w913;
    const double w924 = w216 * w923;
    const double w925 = w215 * w923;
    const double w926 = w215 * w925;
    const double w927 = c[169][l] * w924;
    const double w928 = c[171][l] * w926;
    const double w929 = w927 + w928;
    const double w930 = w219 * w929;
    const double w931 = w217 * w923;
    const double w932 = c[31][l] * w913;
    const double w933 = c[170][l] * w915;
    const double w934 = w932 + w933;
    const double w935 = (-0.2) * w922;
    const double w936 = w934 + w935;
    const double w937 = (-0.2) * w930;
    const double w938 = w936 + w937;
    const double w939 = c[172][l] * w931;
    const double w940 = w938 + w939;
    const double w941 = w[63][l] * w940;
    const double w942 = w224 * w[173][l];
    const double w943 = c[103][l] * w941;
    const double w944 = c[103][l] * w942;
    const double w945 = w943 + w944;
    const double w946 = c[56][l] * w764;
    const double w947 = c[56][l] * w816;
    const double w948 = w[47][l] * w907;
    const double w949 = c[110][l] * w911;
    const double w950 = w[177][l] + w949;
    const double w951 = c[92][l] * w945;
    const double w952 = w950 + w951;
    const double w953 = w239 * w[128][l];
    const double w954 = c[177][l] * w945;
    const double w955 = w[179][l] + w954;
    const double w956 = c[115][l] * w953;
    const double w957 = w955 + w956;
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
    w[77][l] = w273;
    w[78][l] = w274;
    w[83][l] = w331;
    w[85][l] = w367;
    w[89][l] = w368;
    w[90][l] = w369;
    w[91][l] = w379;
    w[96][l] = w456;
    w[98][l] = w486;
    w[102][l] = w487;
    w[103][l] = w488;
    w[104][l] = w489;
    w[105][l] = w497;
    w[106][l] = w509;
    w[109][l] = w567;
    w[111][l] = w603;
    w[114][l] = w604;
    w[115][l] = w605;
    w[117][l] = w617;
    w[120][l] = w673;
    w[121][l] = w674;
    w[122][l] = w675;
    w[124][l] = w679;
    w[126][l] = w684;
    w[131][l] = w692;
    w[132][l] = w693;
    w[137][l] = w737;
    w[139][l] = w753;
    w[143][l] = w754;
    w[144][l] = w755;
    w[145][l] = w765;
    w[150][l] = w818;
    w[152][l] = w833;
    w[156][l] = w834;
    w[157][l] = w835;
    w[158][l] = w836;
    w[159][l] = w839;
    w[160][l] = w840;
    w[163][l] = w880;
    w[165][l] = w896;
    w[168][l] = w897;
    w[169][l] = w898;
    w[171][l] = w910;
    w[174][l] = w946;
    w[175][l] = w947;
    w[176][l] = w948;
    w[178][l] = w952;
    w[180][l] = w957;
}

INLINE void turn2(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
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
    const double w12 = w2 * w2;
    const double w13 = c[143][l] * w12;
    const double w14 = w13 + 1.0;
    const double w15 = 1.0 / w14;
    const double w16 = w[85][l] * w15;
    const double w17 = w6 * w6;
    const double w18 = c[143][l] * w17;
    const double w19 = w18 + 1.0;
    const double w20 = 1.0 / w19;
    const double w21 = w[98][l] * w20;
    const double w22 = w10 * w10;
    const double w23 = c[161][l] * w22;
    const double w24 = w23 + 1.0;
    const double w25 = 1.0 / w24;
    const double w26 = w[111][l] * w25;
    const double w27 = w[139][l] * w15;
    const double w28 = w[152][l] * w20;
    const double w29 = w[165][l] * w25;
    w[17][l] = w3;
    w[34][l] = w7;
    w[54][l] = w11;
    w[86][l] = w16;
    w[99][l] = w21;
    w[112][l] = w26;
    w[140][l] = w27;
    w[153][l] = w28;
    w[166][l] = w29;
}

INLINE void turn3(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
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

INLINE void turn4(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
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
    const double w166 = w28 <= w[24][l] ? 1.0 : 0.0;
    const double w167 = w[24][l] <= w28 ? 1.0 : 0.0;
    const double w168 = w166 + w167;
    const double w169 = 1.0 / w168;
    const double w170 = w166 * w169;
    const double w171 = w170 * w[83][l];
    const double w172 = w167 * w169;
    const double w173 = w27 <= w[13][l] ? 1.0 : 0.0;
    const double w174 = w[13][l] <= w27 ? 1.0 : 0.0;
    const double w175 = w173 + w174;
    const double w176 = 1.0 / w175;
    const double w177 = w173 * w176;
    const double w178 = w22 * w[79][l];
    const double w179 = 0.0 <= w9 ? 1.0 : 0.0;
    const double w180 = w9 <= 0.0 ? 1.0 : 0.0;
    const double w181 = w179 + w180;
    const double w182 = 1.0 / w181;
    const double w183 = w179 * w182;
    const double w184 = w8 <= 1.0 ? 1.0 : 0.0;
    const double w185 = 1.0 <= w8 ? 1.0 : 0.0;
    const double w186 = w184 + w185;
    const double w187 = 1.0 / w186;
    const double w188 = w184 * w187;
    const double w189 = w1 * w[79][l];
    const double w190 = lane_cos(w[18][l]);
    const double w191 = w190 * w[86][l];
    const double w192 = w[19][l] * w191;
    const double w193 = w0 * w[87][l];
    const double w194 = c[145][l] * w192;
    const double w195 = c[146][l] * w193;
    const double w196 = w194 + w195;
    const double w197 = w[10][l] * w196;
    const double w198 = c[11][l] * w189;
    const double w199 = w198 + w197;
    const double w200 = w199 * w[20][l];
    const double w201 = w3 * w[20][l];
    const double w202 = w201 * w[80][l];
    const double w203 = c[147][l] * w202;
    const double w204 = w200 + w203;
    const double w205 = w204 * w[21][l];
    const double w206 = w6 * w[21][l];
    const double w207 = w206 * w[88][l];
    const double w208 = -w207;
    const double w209 = w205 + w208;
    const double w210 = w188 * w209;
    const double w211 = w183 * w210;
    const double w212 = w10 * w211;
    const double w213 = 400.0 * w211;
    const double w214 = (-300.0) * w212;
    const double w215 = w213 + w214;
    const double w216 = w12 * w215;
    const double w217 = w11 * w211;
    const double w218 = w10 * w212;
    const double w219 = 50.0 * w217;
    const double w220 = 100.0 * w218;
    const double w221 = w219 + w220;
    const double w222 = w16 * w221;
    const double w223 = 0.0 <= w19 ? 1.0 : 0.0;
    const double w224 = w19 <= 0.0 ? 1.0 : 0.0;
    const double w225 = w223 + w224;
    const double w226 = 1.0 / w225;
    const double w227 = w223 * w226;
    const double w228 = w227 * w209;
    const double w229 = 0.02 * w216;
    const double w230 = (-0.02) * w222;
    const double w231 = w229 + w230;
    const double w232 = -w228;
    const double w233 = w231 + w232;
    const double w234 = w[10][l] * w233;
    const double w235 = w178 + w234;
    const double w236 = w235 * w[11][l];
    const double w237 = w24 * w[11][l];
    const double w238 = w237 * w[81][l];
    const double w239 = w196 * w[11][l];
    const double w240 = w25 * w[11][l];
    const double w241 = w240 * w[81][l];
    const double w242 = (-0.5) * w238;
    const double w243 = w236 + w242;
    const double w244 = w243 + w239;
    const double w245 = c[148][l] * w241;
    const double w246 = w244 + w245;
    const double w247 = w177 * w246;
    const double w248 = w174 * w176;
    const double w249 = w248 * w[83][l];
    const double w250 = -w249;
    const double w251 = w247 + w250;
    const double w252 = w172 * w251;
    const double w253 = w171 + w252;
    const double w254 = 0.0 <= w31 ? 1.0 : 0.0;
    const double w255 = w31 <= 0.0 ? 1.0 : 0.0;
    const double w256 = w254 + w255;
    const double w257 = 1.0 / w256;
    const double w258 = w254 * w257;
    const double w259 = 100000.0 * w253;
    const double w260 = w[89][l] + w259;
    const double w261 = w258 * w260;
    const double w262 = w34 * w261;
    const double w263 = w33 * w261;
    const double w264 = w32 * w261;
    const double w265 = w32 * w264;
    const double w266 = 2.0 * w265;
    const double w267 = w263 + w266;
    const double w268 = w36 * w267;
    const double w269 = 0.0 <= w39 ? 1.0 : 0.0;
    const double w270 = w39 <= 0.0 ? 1.0 : 0.0;
    const double w271 = w269 + w270;
    const double w272 = 1.0 / w271;
    const double w273 = w269 * w272;
    const double w274 = w[90][l] + w259;
    const double w275 = w273 * w274;
    const double w276 = w41 * w275;
    const double w277 = w40 * w275;
    const double w278 = w40 * w277;
    const double w279 = 2.0 * w278;
    const double w280 = w276 + w279;
    const double w281 = w44 * w280;
    const double w282 = w42 * w275;
    const double w283 = 5e-06 * w262;
    const double w284 = w253 + w283;
    const double w285 = (-1e-05) * w268;
    const double w286 = w284 + w285;
    const double w287 = (-1e-05) * w281;
    const double w288 = w286 + w287;
    const double w289 = 5e-06 * w282;
    const double w290 = w288 + w289;
    const double w291 = w[8][l] * w290;
    const double w292 = w49 * w[77][l];
    const double w293 = c[53][l] * w292;
    const double w294 = w291 + w293;
    const double w295 = w[9][l] * w294;
    const double w296 = w50 * w[78][l];
    const double w297 = c[8][l] * w295;
    const double w298 = c[149][l] * w296;
    const double w299 = w297 + w298;
    const double w300 = c[56][l] * w299;
    const double w301 = w[91][l] + w300;
    const double w302 = w82 <= w[41][l] ? 1.0 : 0.0;
    const double w303 = w[41][l] <= w82 ? 1.0 : 0.0;
    const double w304 = w302 + w303;
    const double w305 = 1.0 / w304;
    const double w306 = w302 * w305;
    const double w307 = w306 * w[96][l];
    const double w308 = w303 * w305;
    const double w309 = w81 <= w[30][l] ? 1.0 : 0.0;
    const double w310 = w[30][l] <= w81 ? 1.0 : 0.0;
    const double w311 = w309 + w310;
    const double w312 = 1.0 / w311;
    const double w313 = w309 * w312;
    const double w314 = w76 * w[92][l];
    const double w315 = 0.0 <= w63 ? 1.0 : 0.0;
    const double w316 = w63 <= 0.0 ? 1.0 : 0.0;
    const double w317 = w315 + w316;
    const double w318 = 1.0 / w317;
    const double w319 = w315 * w318;
    const double w320 = w62 <= 1.0 ? 1.0 : 0.0;
    const double w321 = 1.0 <= w62 ? 1.0 : 0.0;
    const double w322 = w320 + w321;
    const double w323 = 1.0 / w322;
    const double w324 = w320 * w323;
    const double w325 = w55 * w[92][l];
    const double w326 = lane_cos(w[35][l]);
    const double w327 = w326 * w[99][l];
    const double w328 = w[36][l] * w327;
    const double w329 = w54 * w[100][l];
    const double w330 = c[145][l] * w328;
    const double w331 = c[146][l] * w329;
    const double w332 = w330 + w331;
    const double w333 = w[27][l] * w332;
    const double w334 = c[11][l] * w325;
    const double w335 = w334 + w333;
    const double w336 = w335 * w[37][l];
    const double w337 = w57 * w[37][l];
    const double w338 = w337 * w[93][l];
    const double w339 = c[147][l] * w338;
    const double w340 = w336 + w339;
    const double w341 = w340 * w[38][l];
    const double w342 = w60 * w[38][l];
    const double w343 = w342 * w[101][l];
    const double w344 = -w343;
    const double w345 = w341 + w344;
    const double w346 = w324 * w345;
    const double w347 = w319 * w346;
    const double w348 = w64 * w347;
    const double w349 = 400.0 * w347;
    const double w350 = (-300.0) * w348;
    const double w351 = w349 + w350;
    const double w352 = w66 * w351;
    const double w353 = w65 * w347;
    const double w354 = w64 * w348;
    const double w355 = 50.0 * w353;
    const double w356 = 100.0 * w354;
    const double w357 = w355 + w356;
    const double w358 = w70 * w357;
    const double w359 = 0.0 <= w73 ? 1.0 : 0.0;
    const double w360 = w73 <= 0.0 ? 1.0 : 0.0;
    const double w361 = w359 + w360;
    const double w362 = 1.0 / w361;
    const double w363 = w359 * w362;
    const double w364 = w363 * w345;
    const double w365 = 0.02 * w352;
    const double w366 = (-0.02) * w358;
    const double w367 = w365 + w366;
    const double w368 = -w364;
    const double w369 = w367 + w368;
    const double w370 = w[27][l] * w369;
    const double w371 = w314 + w370;
    const double w372 = w371 * w[28][l];
    const double w373 = w78 * w[28][l];
    const double w374 = w373 * w[94][l];
    const double w375 = w332 * w[28][l];
    const double w376 = w79 * w[28][l];
    const double w377 = w376 * w[94][l];
    const double w378 = (-0.5) * w374;
    const double w379 = w372 + w378;
    const double w380 = w379 + w375;
    const double w381 = c[148][l] * w377;
    const double w382 = w380 + w381;
    const double w383 = w313 * w382;
    const double w384 = w310 * w312;
    const double w385 = w384 * w[96][l];
    const double w386 = -w385;
    const double w387 = w383 + w386;
    const double w388 = w308 * w387;
    const double w389 = w307 + w388;
    const double w390 = 0.0 <= w85 ? 1.0 : 0.0;
    const double w391 = w85 <= 0.0 ? 1.0 : 0.0;
    const double w392 = w390 + w391;
    const double w393 = 1.0 / w392;
    const double w394 = w390 * w393;
    const double w395 = 100000.0 * w389;
    const double w396 = w[102][l] + w395;
    const double w397 = w394 * w396;
    const double w398 = w88 * w397;
    const double w399 = w87 * w397;
    const double w400 = w86 * w397;
    const double w401 = w86 * w400;
    const double w402 = 2.0 * w401;
    const double w403 = w399 + w402;
    const double w404 = w90 * w403;
    const double w405 = 0.0 <= w93 ? 1.0 : 0.0;
    const double w406 = w93 <= 0.0 ? 1.0 : 0.0;
    const double w407 = w405 + w406;
    const double w408 = 1.0 / w407;
    const double w409 = w405 * w408;
    const double w410 = w[103][l] + w395;
    const double w411 = w409 * w410;
    const double w412 = w95 * w411;
    const double w413 = w94 * w411;
    const double w414 = w94 * w413;
    const double w415 = 2.0 * w414;
    const double w416 = w412 + w415;
    const double w417 = w98 * w416;
    const double w418 = w96 * w411;
    const double w419 = 5e-06 * w398;
    const double w420 = w389 + w419;
    const double w421 = (-1e-05) * w404;
    const double w422 = w420 + w421;
    const double w423 = (-1e-05) * w417;
    const double w424 = w422 + w423;
    const double w425 = 5e-06 * w418;
    const double w426 = w424 + w425;
    const double w427 = w[8][l] * w426;
    const double w428 = w103 * w[77][l];
    const double w429 = c[53][l] * w428;
    const double w430 = w427 + w429;
    const double w431 = w[9][l] * w430;
    const double w432 = w104 * w[78][l];
    const double w433 = c[13][l] * w431;
    const double w434 = c[153][l] * w432;
    const double w435 = w433 + w434;
    const double w436 = c[56][l] * w435;
    const double w437 = w[104][l] + w436;
    const double w438 = w133 * w[105][l];
    const double w439 = w112 <= w[57][l] ? 1.0 : 0.0;
    const double w440 = w[57][l] <= w112 ? 1.0 : 0.0;
    const double w441 = w439 + w440;
    const double w442 = 1.0 / w441;
    const double w443 = w439 * w442;
    const double w444 = w443 * w[109][l];
    const double w445 = w440 * w442;
    const double w446 = w111 <= w[50][l] ? 1.0 : 0.0;
    const double w447 = w[50][l] <= w111 ? 1.0 : 0.0;
    const double w448 = w446 + w447;
    const double w449 = 1.0 / w448;
    const double w450 = w446 * w449;
    const double w451 = lane_cos(w[55][l]);
    const double w452 = w451 * w[112][l];
    const double w453 = w[56][l] * w452;
    const double w454 = w108 * w[113][l];
    const double w455 = c[163][l] * w453;
    const double w456 = c[164][l] * w454;
    const double w457 = w455 + w456;
    const double w458 = w457 * w[48][l];
    const double w459 = w110 * w[48][l];
    const double w460 = w459 * w[107][l];
    const double w461 = c[165][l] * w460;
    const double w462 = w458 + w461;
    const double w463 = w450 * w462;
    const double w464 = w447 * w449;
    const double w465 = w464 * w[109][l];
    const double w466 = -w465;
    const double w467 = w463 + w466;
    const double w468 = w445 * w467;
    const double w469 = w444 + w468;
    const double w470 = 0.0 <= w115 ? 1.0 : 0.0;
    const double w471 = w115 <= 0.0 ? 1.0 : 0.0;
    const double w472 = w470 + w471;
    const double w473 = 1.0 / w472;
    const double w474 = w470 * w473;
    const double w475 = 100000.0 * w469;
    const double w476 = w[114][l] + w475;
    const double w477 = w474 * w476;
    const double w478 = w118 * w477;
    const double w479 = w117 * w477;
    const double w480 = w116 * w477;
    const double w481 = w116 * w480;
    const double w482 = 2.0 * w481;
    const double w483 = w479 + w482;
    const double w484 = w120 * w483;
    const double w485 = 0.0 <= w123 ? 1.0 : 0.0;
    const double w486 = w123 <= 0.0 ? 1.0 : 0.0;
    const double w487 = w485 + w486;
    const double w488 = 1.0 / w487;
    const double w489 = w485 * w488;
    const double w490 = w[115][l] + w475;
    const double w491 = w489 * w490;
    const double w492 = w125 * w491;
    const double w493 = w124 * w491;
    const double w494 = w124 * w493;
    const double w495 = 2.0 * w494;
    const double w496 = w492 + w495;
    const double w497 = w128 * w496;
    const double w498 = w126 * w491;
    const double w499 = 5e-06 * w478;
    const double w500 = w469 + w499;
    const double w501 = (-1e-05) * w484;
    const double w502 = w500 + w501;
    const double w503 = (-1e-05) * w497;
    const double w504 = w502 + w503;
    const double w505 = 5e-06 * w498;
    const double w506 = w504 + w505;
    const double w507 = w[44][l] * w506;
    const double w508 = c[52][l] * w438;
    const double w509 = w508 + w507;
    const double w510 = w[45][l] * w509;
    const double w511 = w134 * w[106][l];
    const double w512 = c[20][l] * w510;
    const double w513 = c[154][l] * w511;
    const double w514 = w512 + w513;
    const double w515 = w[47][l] * w514;
    const double w516 = c[91][l] * w301;
    const double w517 = w[117][l] + w516;
    const double w518 = c[92][l] * w437;
    const double w519 = w517 + w518;
    const double w520 = c[166][l] * w515;
    const double w521 = w519 + w520;
    const double w522 = c[58][l] * w299;
    const double w523 = w[120][l] + w522;
    const double w524 = c[150][l] * w435;
    const double w525 = w[121][l] + w524;
    const double w526 = w[46][l] * w514;
    const double w527 = c[81][l] * w526;
    const double w528 = w[122][l] + w527;
    const double w529 = c[92][l] * w523;
    const double w530 = w[124][l] + w529;
    const double w531 = c[91][l] * w525;
    const double w532 = w530 + w531;
    const double w533 = c[92][l] * w528;
    const double w534 = w532 + w533;
    const double w535 = c[118][l] * w301;
    const double w536 = w[126][l] + w535;
    const double w537 = c[118][l] * w437;
    const double w538 = w536 + w537;
    const double w539 = c[119][l] * w523;
    const double w540 = w538 + w539;
    const double w541 = c[120][l] * w525;
    const double w542 = w540 + w541;
    const double w543 = c[121][l] * w528;
    const double w544 = w542 + w543;
    const double w545 = w170 * w[137][l];
    const double w546 = w22 * w[133][l];
    const double w547 = w1 * w[133][l];
    const double w548 = w190 * w[140][l];
    const double w549 = w[19][l] * w548;
    const double w550 = w0 * w[141][l];
    const double w551 = c[145][l] * w549;
    const double w552 = c[146][l] * w550;
    const double w553 = w551 + w552;
    const double w554 = w[10][l] * w553;
    const double w555 = c[11][l] * w547;
    const double w556 = w555 + w554;
    const double w557 = w556 * w[20][l];
    const double w558 = w201 * w[134][l];
    const double w559 = c[147][l] * w558;
    const double w560 = w557 + w559;
    const double w561 = w560 * w[21][l];
    const double w562 = w206 * w[142][l];
    const double w563 = -w562;
    const double w564 = w561 + w563;
    const double w565 = w188 * w564;
    const double w566 = w183 * w565;
    const double w567 = w10 * w566;
    const double w568 = 400.0 * w566;
    const double w569 = (-300.0) * w567;
    const double w570 = w568 + w569;
    const double w571 = w12 * w570;
    const double w572 = w11 * w566;
    const double w573 = w10 * w567;
    const double w574 = 50.0 * w572;
    const double w575 = 100.0 * w573;
    const double w576 = w574 + w575;
    const double w577 = w16 * w576;
    const double w578 = w227 * w564;
    const double w579 = 0.02 * w571;
    const double w580 = (-0.02) * w577;
    const double w581 = w579 + w580;
    const double w582 = -w578;
    const double w583 = w581 + w582;
    const double w584 = w[10][l] * w583;
    const double w585 = w546 + w584;
    const double w586 = w585 * w[11][l];
    const double w587 = w237 * w[135][l];
    const double w588 = w553 * w[11][l];
    const double w589 = w240 * w[135][l];
    const double w590 = (-0.5) * w587;
    const double w591 = w586 + w590;
    const double w592 = w591 + w588;
    const double w593 = c[148][l] * w589;
    const double w594 = w592 + w593;
    const double w595 = w177 * w594;
    const double w596 = w248 * w[137][l];
    const double w597 = -w596;
    const double w598 = w595 + w597;
    const double w599 = w172 * w598;
    const double w600 = w545 + w599;
    const double w601 = 100000.0 * w600;
    const double w602 = w[143][l] + w601;
    const double w603 = w258 * w602;
    const double w604 = w34 * w603;
    const double w605 = w33 * w603;
    const double w606 = w32 * w603;
    const double w607 = w32 * w606;
    const double w608 = 2.0 * w607;
    const double w609 = w605 + w608;
    const double w610 = w36 * w609;
    const double w611 = w[144][l] + w601;
    const double w612 = w273 * w611;
    const double w613 = w41 * w612;
    const double w614 = w40 * w612;
    const double w615 = w40 * w614;
    const double w616 = 2.0 * w615;
    const double w617 = w613 + w616;
    const double w618 = w44 * w617;
    const double w619 = w42 * w612;
    const double w620 = 5e-06 * w604;
    const double w621 = w600 + w620;
    const double w622 = (-1e-05) * w610;
    const double w623 = w621 + w622;
    const double w624 = (-1e-05) * w618;
    const double w625 = w623 + w624;
    const double w626 = 5e-06 * w619;
    const double w627 = w625 + w626;
    const double w628 = w[8][l] * w627;
    const double w629 = w49 * w[131][l];
    const double w630 = c[53][l] * w629;
    const double w631 = w628 + w630;
    const double w632 = w[9][l] * w631;
    const double w633 = w50 * w[132][l];
    const double w634 = c[8][l] * w632;
    const double w635 = c[149][l] * w633;
    const double w636 = w634 + w635;
    const double w637 = c[56][l] * w636;
    const double w638 = w[145][l] + w637;
    const double w639 = w306 * w[150][l];
    const double w640 = w76 * w[146][l];
    const double w641 = w55 * w[146][l];
    const double w642 = w326 * w[153][l];
    const double w643 = w[36][l] * w642;
    const double w644 = w54 * w[154][l];
    const double w645 = c[145][l] * w643;
    const double w646 = c[146][l] * w644;
    const double w647 = w645 + w646;
    const double w648 = w[27][l] * w647;
    const double w649 = c[11][l] * w641;
    const double w650 = w649 + w648;
    const double w651 = w650 * w[37][l];
    const double w652 = w337 * w[147][l];
    const double w653 = c[147][l] * w652;
    const double w654 = w651 + w653;
    const double w655 = w654 * w[38][l];
    const double w656 = w342 * w[155][l];
    const double w657 = -w656;
    const double w658 = w655 + w657;
    const double w659 = w324 * w658;
    const double w660 = w319 * w659;
    const double w661 = w64 * w660;
    const double w662 = 400.0 * w660;
    const double w663 = (-300.0) * w661;
    const double w664 = w662 + w663;
    const double w665 = w66 * w664;
    const double w666 = w65 * w660;
    const double w667 = w64 * w661;
    const double w668 = 50.0 * w666;
    const double w669 = 100.0 * w667;
    const double w670 = w668 + w669;
    const double w671 = w70 * w670;
    const double w672 = w363 * w658;
    const double w673 = 0.02 * w665;
    const double w674 = (-0.02) * w671;
    const double w675 = w673 + w674;
    const double w676 = -w672;
    const double w677 = w675 + w676;
    const double w678 = w[27][l] * w677;
    const double w679 = w640 + w678;
    const double w680 = w679 * w[28][l];
    const double w681 = w373 * w[148][l];
    const double w682 = w647 * w[28][l];
    const double w683 = w376 * w[148][l];
    const double w684 = (-0.5) * w681;
    const double w685 = w680 + w684;
    const double w686 = w685 + w682;
    const double w687 = c[148][l] * w683;
    const double w688 = w686 + w687;
    const double w689 = w313 * w688;
    const double w690 = w384 * w[150][l];
    const double w691 = -w690;
    const double w692 = w689 + w691;
    const double w693 = w308 * w692;
    const double w694 = w639 + w693;
    const double w695 = 100000.0 * w694;
    const double w696 = w[156][l] + w695;
    const double w697 = w394 * w696;
    const double w698 = w88 * w697;
    const double w699 = w87 * w697;
    const double w700 = w86 * w697;
    const double w701 = w86 * w700;
    const double w702 = 2.0 * w701;
    const double w703 = w699 + w702;
    const double w704 = w90 * w703;
    const double w705 = w[157][l] + w695;
    const double w706 = w409 * w705;
    const double w707 = w95 * w706;
    const double w708 = w94 * w706;
    const double w709 = w94 * w708;
    const double w710 = 2.0 * w709;
    const double w711 = w707 + w710;
    const double w712 = w98 * w711;
    const double w713 = w96 * w706;
    const double w714 = 5e-06 * w698;
    const double w715 = w694 + w714;
    const double w716 = (-1e-05) * w704;
    const double w717 = w715 + w716;
    const double w718 = (-1e-05) * w712;
    const double w719 = w717 + w718;
    const double w720 = 5e-06 * w713;
    const double w721 = w719 + w720;
    const double w722 = w[8][l] * w721;
    const double w723 = w103 * w[131][l];
    const double w724 = c[53][l] * w723;
    const double w725 = w722 + w724;
    const double w726 = w[9][l] * w725;
    const double w727 = w104 * w[132][l];
    const double w728 = c[13][l] * w726;
    const double w729 = c[153][l] * w727;
    const double w730 = w728 + w729;
    const double w731 = c[56][l] * w730;
    const double w732 = w[158][l] + w731;
    const double w733 = w133 * w[159][l];
    const double w734 = w443 * w[163][l];
    const double w735 = w451 * w[166][l];
    const double w736 = w[56][l] * w735;
    const double w737 = w108 * w[167][l];
    const double w738 = c[163][l] * w736;
    const double w739 = c[164][l] * w737;
    const double w740 = w738 + w739;
    const double w741 = w740 * w[48][l];
    const double w742 = w459 * w[161][l];
    const double w743 = c[165][l] * w742;
    const double w744 = w741 + w743;
    const double w745 = w450 * w744;
    const double w746 = w464 * w[163][l];
    const double w747 = -w746;
    const double w748 = w745 + w747;
    const double w749 = w445 * w748;
    const double w750 = w734 + w749;
    const double w751 = 100000.0 * w750;
    const double w752 = w[168][l] + w751;
    const double w753 = w474 * w752;
    const double w754 = w118 * w753;
    const double w755 = w117 * w753;
    const double w756 = w116 * w753;
    const double w757 = w116 * w756;
    const double w758 = 2.0 * w757;
    const double w759 = w755 + w758;
    const double w760 = w120 * w759;
    const double w761 = w[169][l] + w751;
    const double w762 = w489 * w761;
    const double w763 = w125 * w762;
    const double w764 = w124 * w762;
    const double w765 = w124 * w764;
    const double w766 = 2.0 * w765;
    const double w767 = w763 + w766;
    const double w768 = w128 * w767;
    const double w769 = w126 * w762;
    const double w770 = 5e-06 * w754;
    const double w771 = w750 + w770;
    const double w772 = (-1e-05) * w760;
    const double w773 = w771 + w772;
    const double w774 = (-1e-05) * w768;
    const double w775 = w773 + w774;
    const double w776 = 5e-06 * w769;
    const double w777 = w775 + w776;
    const double w778 = w[44][l] * w777;
    const double w779 = c[52][l] * w733;
    const double w780 = w779 + w778;
    const double w781 = w[45][l] * w780;
    const double w782 = w134 * w[160][l];
    const double w783 = c[20][l] * w781;
    const double w784 = c[154][l] * w782;
    const double w785 = w783 + w784;
    const double w786 = w[47][l] * w785;
    const double w787 = c[91][l] * w638;
    const double w788 = w[171][l] + w787;
    const double w789 = c[92][l] * w732;
    const double w790 = w788 + w789;
    const double w791 = c[166][l] * w786;
    const double w792 = w790 + w791;
    const double w793 = c[58][l] * w636;
    const double w794 = w[174][l] + w793;
    const double w795 = c[150][l] * w730;
    const double w796 = w[175][l] + w795;
    const double w797 = w[46][l] * w785;
    const double w798 = c[81][l] * w797;
    const double w799 = w[176][l] + w798;
    const double w800 = c[92][l] * w794;
    const double w801 = w[178][l] + w800;
    const double w802 = c[91][l] * w796;
    const double w803 = w801 + w802;
    const double w804 = c[92][l] * w799;
    const double w805 = w803 + w804;
    const double w806 = c[118][l] * w638;
    const double w807 = w[180][l] + w806;
    const double w808 = c[118][l] * w732;
    const double w809 = w807 + w808;
    const double w810 = c[119][l] * w794;
    const double w811 = w809 + w810;
    const double w812 = c[120][l] * w796;
    const double w813 = w811 + w812;
    const double w814 = c[121][l] * w799;
    const double w815 = w813 + w814;
    WRITE(f, S0, w142);
    WRITE(f, S1, w155);
    WRITE(f, S2, w165);
    WRITE(r, S0, w521);
    WRITE(r, S1, w534);
    WRITE(r, S2, w544);
    WRITE_MOVING(g, S0, w792);
    WRITE_MOVING(g, S1, w805);
    WRITE_MOVING(g, S2, w815);
}

APART void turns(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g)
{
    lanes w[181];
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
        const double w7 = 2.0 * p[2][l];
        const double w8 = p[18][l] * p[18][l];
        const double w9 = w8 + 1e-12;
        const double w10 = sqrt(w9);
        const double w11 = p[17][l] * w10;
        const double w12 = w7 / w11;
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
        const double w59 = p[36][l] * w58;
        const double w60 = lane_sin(p[12][l]);
        const double w61 = p[41][l] * w60;
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
        const double w75 = p[11][l] * w58;
        const double w76 = p[15][l] * w60;
        const double w77 = w75 + w76;
        const double w78 = -w62;
        const double w79 = w77 + w78;
        const double w80 = 1.0 / w79;
        const double w81 = w80 * 0.5;
        const double w82 = -w81;
        const double w83 = -p[52][l];
        const double w84 = p[4][l] * p[47][l];
        const double w85 = p[4][l] * w83;
        const double w86 = w85 + p[52][l];
        const double w87 = 1.0 / p[47][l];
        const double w88 = lane_sin(p[13][l]);
        const double w89 = p[14][l] * 0.5;
        const double w90 = lane_cos(p[13][l]);
        const double w91 = w90 * w89;
        const double w92 = p[16][l] * p[16][l];
        const double w93 = w92 * w92;
        const double w94 = -w88;
        const double w95 = w94 * w89;
        const double w96 = (-100000.0) * w87;
        const double w97 = 50.0 * p[4][l];
        const double w98 = p[49][l] + -1.0;
        const double w99 = lane_max(1e-12, w98);
        const double w100 = sqrt(w99);
        const double w101 = p[48][l] * w100;
        const double w102 = 1.0 / w101;
        const double w103 = -w102;
        const double w104 = 1e-06 * w92;
        const double w105 = -p[49][l];
        const double w106 = 1.0 + w105;
        const double w107 = 1.0 / p[48][l];
        const double w108 = w107 * p[49][l];
        const double w109 = p[4][l] + (-0.02);
        const double w110 = w88 * p[47][l];
        const double w111 = w90 * p[47][l];
        const double w112 = -w111;
        const double w113 = -p[54][l];
        const double w114 = p[5][l] * p[53][l];
        const double w115 = p[5][l] * w113;
        const double w116 = w115 + p[54][l];
        const double w117 = 1.0 / p[53][l];
        const double w118 = -w89;
        const double w119 = w90 * w118;
        const double w120 = w88 * w118;
        const double w121 = (-100000.0) * w117;
        const double w122 = w90 * p[53][l];
        const double w123 = 50.0 * p[5][l];
        const double w124 = p[5][l] + (-0.02);
        const double w125 = w88 * p[53][l];
        const double w126 = 1.0 / p[61][l];
        const double w127 = p[66][l] * w126;
        const double w128 = p[6][l] * p[55][l];
        const double w129 = w128 + p[7][l];
        const double w130 = -p[56][l];
        const double w131 = 1.0 + w130;
        const double w132 = w129 * w131;
        const double w133 = lane_cos(w132);
        const double w134 = lane_sin(w132);
        const double w135 = -w134;
        const double w136 = (-100000.0) * w127;
        const double w137 = p[63][l] + -1.0;
        const double w138 = lane_max(1e-12, w137);
        const double w139 = sqrt(w138);
        const double w140 = p[62][l] * w139;
        const double w141 = 1.0 / w140;
        const double w142 = -w141;
        const double w143 = 1.0 / p[62][l];
        const double w144 = w143 * p[63][l];
        const double w145 = -w137;
        const double w146 = w131 * p[61][l];
        const double w147 = w134 * w146;
        const double w148 = w133 * p[61][l];
        const double w149 = -w148;
        const double w150 = w52 * w52;
        const double w151 = w150 * p[35][l];
        const double w152 = p[34][l] + w151;
        const double w153 = w152 * w55;
        const double w154 = -w153;
        const double w155 = 1.0 / p[38][l];
        const double w156 = w155 * -1.0;
        const double w157 = w155 * w147;
        const double w158 = w155 * w149;
        const double w159 = w155 * w154;
        const double w160 = w155 * p[2][l];
        const double w161 = 0.5 * p[84][l];
        const double w162 = p[81][l] + 0.1;
        const double w163 = -w162;
        const double w164 = p[80][l] * w60;
        const double w165 = p[79][l] * w58;
        const double w166 = -w165;
        const double w167 = w164 + w166;
        const double w168 = p[6][l] * p[67][l];
        const double w169 = -w168;
        const double w170 = p[8][l] + w169;
        const double w171 = w170 * p[83][l];
        const double w172 = -w171;
        const double w173 = (-5.0) * p[81][l];
        const double w174 = w173 + 0.5;
        const double w175 = p[85][l] * w161;
        const double w176 = p[18][l] * w175;
        const double w177 = -w176;
        const double w178 = p[69][l] * p[71][l];
        const double w179 = 0.25 * p[26][l];
        const double w180 = p[18][l] * w179;
        const double w181 = w178 * w180;
        const double w182 = p[70][l] * w170;
        const double w183 = -w122;
        const double w184 = w134 * p[61][l];
        const double w185 = w133 * w146;
        const double w186 = w155 * w177;
        const double w187 = w155 * w181;
        const double w188 = w155 * w55;
        const double w189 = w155 * p[10][l];
        const double w190 = p[71][l] * p[71][l];
        const double w191 = p[77][l] * w190;
        const double w192 = w191 * w180;
        const double w193 = p[71][l] * w55;
        const double w194 = p[75][l] * p[9][l];
        const double w195 = p[78][l] * w170;
        const double w196 = w194 + w195;
        const double w197 = w167 * w176;
        const double w198 = p[10][l] * w165;
        const double w199 = -w197;
        const double w200 = -w198;
        const double w201 = -w77;
        const double w202 = 1.0 / p[89][l];
        const double w203 = w202 * w192;
        const double w204 = w202 * w193;
        const double w205 = w202 * w199;
        const double w206 = w202 * w89;
        const double w207 = w202 * w201;
        const double w208 = w202 * w77;
        const double w209 = w202 * w78;
        const double w210 = w202 * w200;
        const double w211 = w75 + w78;
        const double w212 = w211 + w76;
        const double w213 = 1.0 / w212;
        const double w214 = w213 * 0.5;
        const double w215 = -w214;
        const double w216 = w190 * w180;
        const double w217 = p[74][l] * w216;
        const double w218 = p[72][l] * p[9][l];
        const double w219 = p[77][l] * w216;
        const double w220 = p[10][l] * p[79][l];
        const double w221 = w220 * w60;
        const double w222 = p[79][l] * w176;
        const double w223 = w60 * w222;
        const double w224 = p[80][l] * w176;
        const double w225 = w58 * w224;
        const double w226 = w223 + w225;
        const double w227 = -w226;
        const double w228 = w58 * p[15][l];
        const double w229 = -w228;
        const double w230 = p[11][l] * w60;
        const double w231 = w229 + w230;
        const double w232 = -w230;
        const double w233 = w228 + w232;
        const double w234 = w58 * p[41][l];
        const double w235 = -w234;
        const double w236 = p[36][l] * w60;
        const double w237 = w235 + w236;
        const double w238 = w63 * w19;
        const double w239 = w64 * w19;
        const double w240 = w238 + w239;
        const double w241 = -w240;
        const double w242 = -w72;
        const double w243 = p[15][l] * w58;
        const double w244 = -w243;
        const double w245 = w230 + w244;
        const double w246 = w232 + w243;
        const double w247 = -w74;
        const double w248 = -p[86][l];
        const double w249 = (-0.5) * p[87][l];
        const double w250 = -p[88][l];
        const double w251 = w87 * w87;
        const double w252 = p[46][l] * w81;
        const double w253 = p[47][l] * w252;
        const double w254 = w251 * w253;
        const double w255 = p[4][l] * w253;
        const double w256 = w255 * w87;
        const double w257 = -w256;
        const double w258 = p[44][l] * w81;
        const double w259 = -w258;
        const double w260 = p[48][l] * p[48][l];
        const double w261 = p[49][l] * p[48][l];
        const double w262 = w107 * w261;
        const double w263 = p[50][l] * p[48][l];
        const double w264 = p[51][l] * w263;
        const double w265 = p[51][l] * 0.5;
        const double w266 = -p[51][l];
        const double w267 = -w265;
        const double w268 = -w253;
        const double w269 = -w90;
        const double w270 = w117 * w117;
        const double w271 = p[53][l] * w252;
        const double w272 = w270 * w271;
        const double w273 = p[5][l] * w271;
        const double w274 = w273 * w117;
        const double w275 = -w274;
        const double w276 = -w271;
        const double w277 = w127 * w126;
        const double w278 = p[60][l] * w80;
        const double w279 = p[61][l] * w278;
        const double w280 = w277 * w279;
        const double w281 = -w280;
        const double w282 = (-100000.0) * w280;
        const double w283 = -w282;
        const double w284 = p[58][l] * w80;
        const double w285 = w126 * w126;
        const double w286 = w285 * w279;
        const double w287 = -w286;
        const double w288 = p[62][l] * p[62][l];
        const double w289 = p[63][l] * p[62][l];
        const double w290 = w143 * w289;
        const double w291 = p[64][l] * p[62][l];
        const double w292 = p[65][l] * w291;
        const double w293 = p[65][l] * 0.5;
        const double w294 = -w293;
        const double w295 = w134 * w131;
        const double w296 = -w133;
        const double w297 = -w154;
        const double w298 = w155 * w295;
        const double w299 = w155 * w296;
        const double w300 = w155 * w297;
        const double w301 = w179 * 0.5;
        const double w302 = w178 * p[18][l];
        const double w303 = w55 * p[68][l];
        const double w304 = 5.0 * p[82][l];
        const double w305 = 0.5 * w304;
        const double w306 = 0.2 * w305;
        const double w307 = 2.0 * w304;
        const double w308 = -w306;
        const double w309 = -w308;
        const double w310 = w133 * w131;
        const double w311 = w155 * w302;
        const double w312 = w155 * w303;
        const double w313 = w191 * p[18][l];
        const double w314 = w193 * p[76][l];
        const double w315 = -w167;
        const double w316 = w202 * w313;
        const double w317 = w202 * w314;
        const double w318 = w202 * w315;
        const double w319 = w53 * 2.0;
        const double w320 = p[18][l] * w319;
        const double w321 = p[30][l] * w320;
        const double w322 = w71 * w321;
        const double w323 = w52 * w320;
        const double w324 = w90 * 2.0;
        const double w325 = w88 * 2.0;
        const double w326 = -w325;
        const double w327 = w324 * 0.5;
        const double w328 = -w87;
        const double w329 = w88 * p[51][l];
        const double w330 = -w329;
        const double w331 = w88 * w268;
        const double w332 = w269 * p[47][l];
        const double w333 = w269 * w268;
        const double w334 = -w327;
        const double w335 = w90 * w276;
        const double w336 = w88 * w276;
        const double w337 = -w335;
        const double w338 = -w125;
        const double w339 = -w336;
        const double w340 = w133 * 2.0;
        const double w341 = w134 * 2.0;
        const double w342 = -w341;
        const double w343 = w340 * 0.5;
        const double w344 = w295 * p[61][l];
        const double w345 = w295 * w279;
        const double w346 = w296 * p[61][l];
        const double w347 = w296 * w279;
        const double w348 = w152 * w320;
        const double w349 = w176 * 2.0;
        const double w350 = -w349;
        const double w351 = w62 * w323;
        const double w352 = -w351;
        const double w353 = w90 * p[51][l];
        const double w354 = w325 * 0.5;
        const double w355 = -w354;
        const double w356 = w90 * w268;
        const double w357 = -w110;
        const double w358 = -w331;
        const double w359 = -w356;
        const double w360 = w269 * p[53][l];
        const double w361 = w269 * w276;
        const double w362 = w77 * w323;
        const double w363 = -w362;
        const double w364 = w341 * 0.5;
        const double w365 = -w364;
        const double w366 = w134 * w279;
        const double w367 = w310 * p[61][l];
        const double w368 = w310 * w279;
        const double w369 = -w184;
        const double w370 = -w366;
        const double w371 = -w367;
        const double w372 = -w368;
        const double w373 = w155 * w110;
        const double w374 = w155 * w331;
        const double w375 = w155 * w332;
        const double w376 = w155 * w333;
        const double w377 = w155 * w183;
        const double w378 = w155 * w337;
        const double w379 = w155 * w338;
        const double w380 = w155 * w339;
        const double w381 = w155 * w344;
        const double w382 = w155 * w345;
        const double w383 = w155 * w346;
        const double w384 = w155 * w347;
        const double w385 = w155 * w320;
        const double w386 = w155 * w350;
        const double w387 = w155 * w357;
        const double w388 = w155 * w358;
        const double w389 = w155 * w112;
        const double w390 = w155 * w359;
        const double w391 = w155 * w125;
        const double w392 = w155 * w336;
        const double w393 = w155 * w360;
        const double w394 = w155 * w361;
        const double w395 = w155 * w369;
        const double w396 = w155 * w370;
        const double w397 = w155 * w371;
        const double w398 = w155 * w372;
        const double w399 = p[82][l] * w167;
        const double w400 = 5.0 * w399;
        const double w401 = 0.5 * w400;
        const double w402 = 0.2 * w401;
        const double w403 = 2.0 * w400;
        const double w404 = -w402;
        const double w405 = -w404;
        const double w406 = w167 * 2.0;
        const double w407 = w176 * w406;
        const double w408 = w315 * w176;
        const double w409 = w315 * w407;
        const double w410 = w88 * w77;
        const double w411 = 0.5 * p[14][l];
        const double w412 = w90 * w411;
        const double w413 = w410 + w412;
        const double w414 = w413 * 2.0;
        const double w415 = w90 * w77;
        const double w416 = w88 * w411;
        const double w417 = -w416;
        const double w418 = w415 + w417;
        const double w419 = w418 * 2.0;
        const double w420 = w418 * p[51][l];
        const double w421 = w414 * 0.5;
        const double w422 = -w421;
        const double w423 = w106 * w87;
        const double w424 = p[48][l] * w87;
        const double w425 = p[49][l] * w424;
        const double w426 = w107 * w425;
        const double w427 = w89 * w110;
        const double w428 = w89 * w112;
        const double w429 = w412 + w410;
        const double w430 = w429 * 2.0;
        const double w431 = -w430;
        const double w432 = w430 * 0.5;
        const double w433 = w106 * w117;
        const double w434 = p[48][l] * w117;
        const double w435 = p[49][l] * w434;
        const double w436 = w107 * w435;
        const double w437 = w89 * w122;
        const double w438 = w89 * w125;
        const double w439 = w201 * w110;
        const double w440 = w428 + w439;
        const double w441 = w201 * w111;
        const double w442 = w427 + w441;
        const double w443 = w77 * w125;
        const double w444 = w437 + w443;
        const double w445 = w77 * w183;
        const double w446 = w438 + w445;
        const double w447 = w134 * w62;
        const double w448 = w447 * 2.0;
        const double w449 = w133 * w62;
        const double w450 = w449 * 2.0;
        const double w451 = w448 * 0.5;
        const double w452 = -w451;
        const double w453 = p[62][l] * w126;
        const double w454 = p[63][l] * w453;
        const double w455 = w143 * w454;
        const double w456 = w137 * w126;
        const double w457 = -w456;
        const double w458 = w78 * w184;
        const double w459 = w78 * w185;
        const double w460 = w202 * w408;
        const double w461 = w202 * w409;
        const double w462 = w386 + w461;
        const double w463 = w202 * w442;
        const double w464 = w202 * w440;
        const double w465 = w202 * w444;
        const double w466 = w202 * w446;
        const double w467 = w202 * w458;
        const double w468 = w202 * w459;
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
        c[31][l] = w12;
        c[32][l] = w14;
        c[33][l] = w16;
        c[34][l] = w19;
        c[35][l] = w20;
        c[36][l] = w52;
        c[37][l] = w54;
        c[38][l] = w55;
        c[39][l] = w56;
        c[40][l] = w57;
        c[41][l] = w62;
        c[42][l] = w66;
        c[43][l] = w72;
        c[44][l] = w74;
        c[45][l] = w77;
        c[46][l] = w78;
        c[47][l] = w80;
        c[48][l] = w82;
        c[49][l] = w84;
        c[50][l] = w86;
        c[51][l] = w87;
        c[52][l] = w88;
        c[53][l] = w89;
        c[54][l] = w90;
        c[55][l] = w91;
        c[56][l] = w93;
        c[57][l] = w94;
        c[58][l] = w95;
        c[59][l] = w96;
        c[60][l] = w97;
        c[61][l] = w102;
        c[62][l] = w103;
        c[63][l] = w104;
        c[64][l] = w106;
        c[65][l] = w108;
        c[66][l] = w109;
        c[67][l] = w110;
        c[68][l] = w111;
        c[69][l] = w112;
        c[70][l] = w114;
        c[71][l] = w116;
        c[72][l] = w117;
        c[73][l] = w119;
        c[74][l] = w120;
        c[75][l] = w121;
        c[76][l] = w122;
        c[77][l] = w123;
        c[78][l] = w124;
        c[79][l] = w125;
        c[80][l] = w126;
        c[81][l] = w127;
        c[82][l] = w133;
        c[83][l] = w134;
        c[84][l] = w135;
        c[85][l] = w136;
        c[86][l] = w141;
        c[87][l] = w142;
        c[88][l] = w144;
        c[89][l] = w145;
        c[90][l] = w146;
        c[91][l] = w147;
        c[92][l] = w149;
        c[93][l] = w153;
        c[94][l] = w154;
        c[95][l] = w155;
        c[96][l] = w156;
        c[97][l] = w157;
        c[98][l] = w158;
        c[99][l] = w159;
        c[100][l] = w160;
        c[101][l] = w162;
        c[102][l] = w163;
        c[103][l] = w167;
        c[104][l] = w172;
        c[105][l] = w174;
        c[106][l] = w176;
        c[107][l] = w177;
        c[108][l] = w179;
        c[109][l] = w181;
        c[110][l] = w182;
        c[111][l] = w183;
        c[112][l] = w184;
        c[113][l] = w185;
        c[114][l] = w186;
        c[115][l] = w187;
        c[116][l] = w188;
        c[117][l] = w189;
        c[118][l] = w193;
        c[119][l] = w196;
        c[120][l] = w199;
        c[121][l] = w200;
        c[122][l] = w201;
        c[123][l] = w203;
        c[124][l] = w204;
        c[125][l] = w205;
        c[126][l] = w206;
        c[127][l] = w207;
        c[128][l] = w208;
        c[129][l] = w209;
        c[130][l] = w210;
        c[131][l] = w213;
        c[132][l] = w215;
        c[133][l] = w217;
        c[134][l] = w218;
        c[135][l] = w219;
        c[136][l] = w221;
        c[137][l] = w227;
        c[138][l] = w231;
        c[139][l] = w233;
        c[140][l] = w237;
        c[141][l] = w241;
        c[142][l] = w242;
        c[143][l] = w245;
        c[144][l] = w246;
        c[145][l] = w247;
        c[146][l] = w248;
        c[147][l] = w249;
        c[148][l] = w250;
        c[149][l] = w254;
        c[150][l] = w257;
        c[151][l] = w258;
        c[152][l] = w259;
        c[153][l] = w260;
        c[154][l] = w262;
        c[155][l] = w264;
        c[156][l] = w265;
        c[157][l] = w266;
        c[158][l] = w267;
        c[159][l] = w268;
        c[160][l] = w269;
        c[161][l] = w272;
        c[162][l] = w275;
        c[163][l] = w276;
        c[164][l] = w279;
        c[165][l] = w280;
        c[166][l] = w281;
        c[167][l] = w282;
        c[168][l] = w283;
        c[169][l] = w284;
        c[170][l] = w287;
        c[171][l] = w288;
        c[172][l] = w290;
        c[173][l] = w292;
        c[174][l] = w293;
        c[175][l] = w294;
        c[176][l] = w298;
        c[177][l] = w299;
        c[178][l] = w300;
        c[179][l] = w301;
        c[180][l] = w304;
        c[181][l] = w306;
        c[182][l] = w307;
        c[183][l] = w309;
        c[184][l] = w310;
        c[185][l] = w311;
        c[186][l] = w312;
        c[187][l] = w316;
        c[188][l] = w317;
        c[189][l] = w318;
        c[190][l] = w322;
        c[191][l] = w323;
        c[192][l] = w324;
        c[193][l] = w325;
        c[194][l] = w326;
        c[195][l] = w327;
        c[196][l] = w328;
        c[197][l] = w329;
        c[198][l] = w330;
        c[199][l] = w334;
        c[200][l] = w340;
        c[201][l] = w341;
        c[202][l] = w342;
        c[203][l] = w343;
        c[204][l] = w348;
        c[205][l] = w352;
        c[206][l] = w353;
        c[207][l] = w354;
        c[208][l] = w355;
        c[209][l] = w363;
        c[210][l] = w365;
        c[211][l] = w373;
        c[212][l] = w374;
        c[213][l] = w375;
        c[214][l] = w376;
        c[215][l] = w377;
        c[216][l] = w378;
        c[217][l] = w379;
        c[218][l] = w380;
        c[219][l] = w381;
        c[220][l] = w382;
        c[221][l] = w383;
        c[222][l] = w384;
        c[223][l] = w385;
        c[224][l] = w387;
        c[225][l] = w388;
        c[226][l] = w389;
        c[227][l] = w390;
        c[228][l] = w391;
        c[229][l] = w392;
        c[230][l] = w393;
        c[231][l] = w394;
        c[232][l] = w395;
        c[233][l] = w396;
        c[234][l] = w397;
        c[235][l] = w398;
        c[236][l] = w399;
        c[237][l] = w400;
        c[238][l] = w402;
        c[239][l] = w403;
        c[240][l] = w405;
        c[241][l] = w413;
        c[242][l] = w414;
        c[243][l] = w418;
        c[244][l] = w419;
        c[245][l] = w420;
        c[246][l] = w422;
        c[247][l] = w423;
        c[248][l] = w426;
        c[249][l] = w429;
        c[250][l] = w431;
        c[251][l] = w432;
        c[252][l] = w433;
        c[253][l] = w436;
        c[254][l] = w447;
        c[255][l] = w448;
        c[256][l] = w449;
        c[257][l] = w450;
        c[258][l] = w452;
        c[259][l] = w455;
        c[260][l] = w457;
        c[261][l] = w460;
        c[262][l] = w462;
        c[263][l] = w463;
        c[264][l] = w464;
        c[265][l] = w465;
        c[266][l] = w466;
        c[267][l] = w467;
        c[268][l] = w468;
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
    const double w9 = w8 + 1e-06;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = w11 + c[31][l];
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
    const double w29 = w8 + 1e-08;
    const double w30 = c[1][l] * w1;
    const double w31 = c[37][l] * w2;
    const double w32 = w30 + w31;
    const double w33 = -w32;
    const double w34 = x1 + w33;
    const double w35 = w34 * w34;
    const double w36 = w29 + w35;
    const double w37 = w36 * w7;
    const double w38 = sqrt(w29);
    const double w39 = 1.0 / w38;
    const double w40 = w37 * w39;
    const double w41 = c[40][l] * w40;
    const double w42 = w41 + c[27][l];
    const double w43 = c[43][l] * w36;
    const double w44 = w43 + c[44][l];
    const double w45 = c[45][l] * x2;
    const double w46 = x1 + w45;
    const double w47 = c[54][l] * x0;
    const double w48 = c[55][l] * x2;
    const double w49 = w47 + w48;
    const double w50 = c[52][l] * w46;
    const double w51 = w49 + w50;
    const double w52 = w51 * w51;
    const double w53 = c[57][l] * x0;
    const double w54 = c[58][l] * x2;
    const double w55 = w53 + w54;
    const double w56 = c[54][l] * w46;
    const double w57 = w55 + w56;
    const double w58 = w57 * w57;
    const double w59 = w52 + w58;
    const double w60 = w59 * w59;
    const double w61 = w60 + c[56][l];
    const double w62 = sqrt(w61);
    const double w63 = sqrt(w62);
    const double w64 = 1.0 / w63;
    const double w65 = w51 * w64;
    const double w66 = w52 + c[63][l];
    const double w67 = sqrt(w66);
    const double w68 = 1.0 / w67;
    const double w69 = w57 * w68;
    const double w70 = w58 + w66;
    const double w71 = sqrt(w70);
    const double w72 = 1.0 / w62;
    const double w73 = w58 * w72;
    const double w74 = w73 + 5e-13;
    const double w75 = 1.0 / w74;
    const double w76 = c[73][l] * x2;
    const double w77 = w47 + w76;
    const double w78 = c[57][l] * w46;
    const double w79 = w77 + w78;
    const double w80 = w79 * w79;
    const double w81 = c[52][l] * x0;
    const double w82 = c[74][l] * x2;
    const double w83 = w81 + w82;
    const double w84 = w83 + w56;
    const double w85 = w84 * w84;
    const double w86 = w80 + w85;
    const double w87 = w86 * w86;
    const double w88 = w87 + c[56][l];
    const double w89 = sqrt(w88);
    const double w90 = sqrt(w89);
    const double w91 = 1.0 / w90;
    const double w92 = w79 * w91;
    const double w93 = w80 + c[63][l];
    const double w94 = sqrt(w93);
    const double w95 = 1.0 / w94;
    const double w96 = w84 * w95;
    const double w97 = w85 + w93;
    const double w98 = sqrt(w97);
    const double w99 = 1.0 / w89;
    const double w100 = w85 * w99;
    const double w101 = w100 + 5e-13;
    const double w102 = 1.0 / w101;
    const double w103 = c[41][l] * x2;
    const double w104 = x1 + w103;
    const double w105 = c[82][l] * x0;
    const double w106 = c[83][l] * w104;
    const double w107 = w105 + w106;
    const double w108 = w107 * w107;
    const double w109 = c[84][l] * x0;
    const double w110 = c[82][l] * w104;
    const double w111 = w109 + w110;
    const double w112 = w111 * w111;
    const double w113 = w108 + w112;
    const double w114 = w113 * w113;
    const double w115 = w114 + c[56][l];
    const double w116 = sqrt(w115);
    const double w117 = sqrt(w116);
    const double w118 = 1.0 / w117;
    const double w119 = w107 * w118;
    const double w120 = w108 + c[63][l];
    const double w121 = sqrt(w120);
    const double w122 = 1.0 / w121;
    const double w123 = w111 * w122;
    const double w124 = w112 + w120;
    const double w125 = sqrt(w124);
    const double w126 = w0 + c[100][l];
    const double w127 = c[99][l] * w40;
    const double w128 = w126 + w127;
    const double w129 = c[103][l] * x2;
    const double w130 = x1 + w129;
    const double w131 = w130 + w33;
    const double w132 = w131 * w131;
    const double w133 = w27 + w132;
    const double w134 = sqrt(w36);
    const double w135 = w134 * x2;
    const double w136 = x2 * x0;
    const double w137 = -w136;
    const double w138 = w137 + c[117][l];
    const double w139 = c[115][l] * w135;
    const double w140 = w138 + w139;
    const double w141 = c[123][l] * w135;
    const double w142 = w141 + c[130][l];
    const double w143 = x0 * w1;
    const double w144 = x1 * w2;
    const double w145 = -w144;
    const double w146 = w143 + w145;
    const double w147 = x0 * w2;
    const double w148 = x1 * w1;
    const double w149 = w147 + w148;
    w[0][l] = w27;
    w[1][l] = w28;
    w[2][l] = w34;
    w[3][l] = w36;
    w[4][l] = w38;
    w[5][l] = w42;
    w[6][l] = w44;
    w[9][l] = w57;
    w[10][l] = w64;
    w[11][l] = w65;
    w[13][l] = w69;
    w[18][l] = w71;
    w[19][l] = w72;
    w[20][l] = w75;
    w[24][l] = w84;
    w[25][l] = w91;
    w[26][l] = w92;
    w[28][l] = w96;
    w[33][l] = w98;
    w[34][l] = w99;
    w[35][l] = w102;
    w[41][l] = w118;
    w[42][l] = w119;
    w[44][l] = w123;
    w[49][l] = w125;
    w[52][l] = w128;
    w[54][l] = w131;
    w[55][l] = w133;
    w[59][l] = w140;
    w[61][l] = w142;
    WRITE(f, S3, w146);
    WRITE(f, S4, w149);
    WRITE(f, S5, x2);
}

INLINE void rate1(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan2(0.0, w[1][l]);
    const double w1 = c[30][l] * w0;
    const double w2 = w1 + c[32][l];
    const double w3 = c[5][l] * w2;
    const double w4 = lane_min(c[28][l], w3);
    const double w5 = lane_max(c[29][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[33][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[33][l];
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
    const double w27 = c[35][l] * w26;
    const double w28 = w[5][l] + w27;
    const double w29 = c[42][l] * w26;
    const double w30 = w[6][l] + w29;
    const double w31 = c[41][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[48][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[9][l] * w34;
    const double w36 = w35 + c[8][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[49][l] * w37;
    const double w40 = w39 + c[50][l];
    const double w41 = w40 * w38;
    const double w42 = c[51][l] * w41;
    const double w43 = w42 + 5e-06;
    const double w44 = lane_min(w43, w[11][l]);
    const double w45 = -w43;
    const double w46 = lane_max(w45, w44);
    const double w47 = c[59][l] * w41;
    const double w48 = w47 + 0.5;
    const double w49 = (-100000.0) * w46;
    const double w50 = w48 + w49;
    const double w51 = lane_max(0.0, w50);
    const double w52 = w51 * w51;
    const double w53 = w51 * w52;
    const double w54 = (-0.5) * w51;
    const double w55 = w54 + 1.0;
    const double w56 = w53 * w55;
    const double w57 = 100000.0 * w46;
    const double w58 = w48 + w57;
    const double w59 = lane_max(0.0, w58);
    const double w60 = w59 * w59;
    const double w61 = w59 * w60;
    const double w62 = (-0.5) * w59;
    const double w63 = w62 + 1.0;
    const double w64 = w61 * w63;
    const double w65 = 1e-05 * w56;
    const double w66 = w46 + w65;
    const double w67 = (-1e-05) * w64;
    const double w68 = w66 + w67;
    const double w69 = w68 * w68;
    const double w70 = -w69;
    const double w71 = w70 + 1.0;
    const double w72 = sqrt(w71);
    const double w73 = w72 + 5e-06;
    const double w74 = c[7][l] * w34;
    const double w75 = w74 + c[6][l];
    const double w76 = lane_max(0.0, w75);
    const double w77 = w76 * w[13][l];
    const double w78 = w77 * w38;
    const double w79 = c[51][l] * w78;
    const double w80 = lane_min(w79, c[61][l]);
    const double w81 = lane_max(c[62][l], w80);
    const double w82 = c[11][l] * w81;
    const double w83 = c[64][l] * w81;
    const double w84 = -w73;
    const double w85 = (-100000.0) * w72;
    const double w86 = w85 + 0.5;
    const double w87 = w34 * w68;
    const double w88 = w87 * w37;
    const double w89 = c[69][l] * w88;
    const double w90 = c[70][l] * w37;
    const double w91 = w90 + c[71][l];
    const double w92 = w91 * w38;
    const double w93 = c[72][l] * w92;
    const double w94 = w93 + 5e-06;
    const double w95 = lane_min(w94, w[26][l]);
    const double w96 = -w94;
    const double w97 = lane_max(w96, w95);
    const double w98 = c[75][l] * w92;
    const double w99 = w98 + 0.5;
    const double w100 = (-100000.0) * w97;
    const double w101 = w99 + w100;
    const double w102 = lane_max(0.0, w101);
    const double w103 = w102 * w102;
    const double w104 = w102 * w103;
    const double w105 = (-0.5) * w102;
    const double w106 = w105 + 1.0;
    const double w107 = w104 * w106;
    const double w108 = 100000.0 * w97;
    const double w109 = w99 + w108;
    const double w110 = lane_max(0.0, w109);
    const double w111 = w110 * w110;
    const double w112 = w110 * w111;
    const double w113 = (-0.5) * w110;
    const double w114 = w113 + 1.0;
    const double w115 = w112 * w114;
    const double w116 = 1e-05 * w107;
    const double w117 = w97 + w116;
    const double w118 = (-1e-05) * w115;
    const double w119 = w117 + w118;
    const double w120 = w34 * w119;
    const double w121 = w120 * w37;
    const double w122 = w119 * w119;
    const double w123 = -w122;
    const double w124 = w123 + 1.0;
    const double w125 = sqrt(w124);
    const double w126 = w125 + 5e-06;
    const double w127 = w76 * w[28][l];
    const double w128 = w127 * w38;
    const double w129 = c[72][l] * w128;
    const double w130 = lane_min(w129, c[61][l]);
    const double w131 = lane_max(c[62][l], w130);
    const double w132 = c[11][l] * w131;
    const double w133 = c[64][l] * w131;
    const double w134 = -w126;
    const double w135 = (-100000.0) * w125;
    const double w136 = w135 + 0.5;
    const double w137 = c[76][l] * w121;
    const double w138 = c[45][l] * w28;
    const double w139 = w138 + w30;
    const double w140 = c[47][l] * w139;
    const double w141 = lane_max(0.0, w140);
    const double w142 = c[18][l] * w141;
    const double w143 = w142 + c[17][l];
    const double w144 = lane_max(0.001, w143);
    const double w145 = 1.0 / w144;
    const double w146 = c[81][l] * w145;
    const double w147 = w146 + 5e-06;
    const double w148 = lane_min(w147, w[42][l]);
    const double w149 = -w147;
    const double w150 = lane_max(w149, w148);
    const double w151 = c[85][l] * w145;
    const double w152 = w151 + 0.5;
    const double w153 = (-100000.0) * w150;
    const double w154 = w152 + w153;
    const double w155 = lane_max(0.0, w154);
    const double w156 = w155 * w155;
    const double w157 = w155 * w156;
    const double w158 = (-0.5) * w155;
    const double w159 = w158 + 1.0;
    const double w160 = w157 * w159;
    const double w161 = 100000.0 * w150;
    const double w162 = w152 + w161;
    const double w163 = lane_max(0.0, w162);
    const double w164 = w163 * w163;
    const double w165 = w163 * w164;
    const double w166 = (-0.5) * w163;
    const double w167 = w166 + 1.0;
    const double w168 = w165 * w167;
    const double w169 = 1e-05 * w160;
    const double w170 = w150 + w169;
    const double w171 = (-1e-05) * w168;
    const double w172 = w170 + w171;
    const double w173 = w172 * w172;
    const double w174 = -w173;
    const double w175 = w174 + 1.0;
    const double w176 = sqrt(w175);
    const double w177 = w176 + 5e-06;
    const double w178 = c[16][l] * w141;
    const double w179 = w178 + c[15][l];
    const double w180 = lane_max(0.0, w179);
    const double w181 = w180 * w[44][l];
    const double w182 = w181 * w145;
    const double w183 = c[80][l] * w182;
    const double w184 = lane_min(w183, c[86][l]);
    const double w185 = lane_max(c[87][l], w184);
    const double w186 = c[20][l] * w185;
    const double w187 = c[89][l] * w185;
    const double w188 = -w177;
    const double w189 = (-100000.0) * w176;
    const double w190 = w189 + 0.5;
    const double w191 = w141 * w172;
    const double w192 = w191 * w144;
    const double w193 = c[98][l] * w192;
    const double w194 = w[52][l] + w193;
    const double w195 = lane_atan2(w[54][l], w[1][l]);
    const double w196 = w195 + c[104][l];
    const double w197 = c[26][l] * w196;
    const double w198 = lane_min(c[101][l], w197);
    const double w199 = lane_max(c[102][l], w198);
    const double w200 = (-5.0) * w199;
    const double w201 = w200 + c[105][l];
    const double w202 = lane_max(0.0, w201);
    const double w203 = w202 * w202;
    const double w204 = w202 * w203;
    const double w205 = (-0.5) * w202;
    const double w206 = w205 + 1.0;
    const double w207 = w204 * w206;
    const double w208 = 5.0 * w199;
    const double w209 = w208 + c[105][l];
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
    const double w220 = w219 * w[55][l];
    const double w221 = lane_atan2(w[2][l], w[4][l]);
    const double w222 = c[23][l] * w221;
    const double w223 = w222 + c[110][l];
    const double w224 = w[3][l] * w223;
    const double w225 = c[67][l] * w88;
    const double w226 = c[79][l] * w121;
    const double w227 = c[112][l] * w192;
    const double w228 = c[114][l] * w220;
    const double w229 = w[59][l] + w228;
    const double w230 = c[116][l] * w224;
    const double w231 = w229 + w230;
    const double w232 = c[25][l] * w221;
    const double w233 = w232 + c[119][l];
    const double w234 = w[3][l] * w233;
    const double w235 = c[125][l] * w220;
    const double w236 = w[61][l] + w235;
    const double w237 = c[124][l] * w234;
    const double w238 = w236 + w237;
    w[7][l] = w34;
    w[8][l] = w37;
    w[12][l] = w73;
    w[14][l] = w82;
    w[15][l] = w83;
    w[21][l] = w84;
    w[22][l] = w86;
    w[23][l] = w89;
    w[27][l] = w126;
    w[29][l] = w132;
    w[30][l] = w133;
    w[36][l] = w134;
    w[37][l] = w136;
    w[38][l] = w137;
    w[39][l] = w141;
    w[40][l] = w144;
    w[43][l] = w177;
    w[45][l] = w186;
    w[46][l] = w187;
    w[50][l] = w188;
    w[51][l] = w190;
    w[53][l] = w194;
    w[56][l] = w225;
    w[57][l] = w226;
    w[58][l] = w227;
    w[60][l] = w231;
    w[62][l] = w238;
}

INLINE void rate2(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[14][l]);
    const double w1 = c[65][l] * w0;
    const double w2 = w[15][l] + w1;
    const double w3 = c[11][l] * w2;
    const double w4 = lane_atan(w[29][l]);
    const double w5 = c[65][l] * w4;
    const double w6 = w[30][l] + w5;
    const double w7 = c[11][l] * w6;
    const double w8 = lane_atan(w[45][l]);
    const double w9 = c[88][l] * w8;
    const double w10 = w[46][l] + w9;
    const double w11 = c[20][l] * w10;
    w[16][l] = w3;
    w[31][l] = w7;
    w[47][l] = w11;
}

INLINE void rate3(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_atan(w[16][l]);
    const double w1 = c[12][l] * w0;
    const double w2 = lane_atan(w[31][l]);
    const double w3 = c[12][l] * w2;
    const double w4 = lane_atan(w[47][l]);
    const double w5 = c[21][l] * w4;
    w[17][l] = w1;
    w[32][l] = w3;
    w[48][l] = w5;
}

INLINE void rate4(const lanes *c, const lanes *u, const lanes *x, lanes *f, lanes *w, int l)
{
    const double w0 = lane_sin(w[17][l]);
    const double w1 = w0 * w[18][l];
    const double w2 = w[9][l] * w1;
    const double w3 = w2 * w[19][l];
    const double w4 = c[13][l] * w3;
    const double w5 = w4 + 1e-12;
    const double w6 = w5 * w[20][l];
    const double w7 = (-50.0) * w6;
    const double w8 = w7 + c[60][l];
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
    const double w19 = w18 + c[66][l];
    const double w20 = lane_max(0.0, w19);
    const double w21 = 0.02 * w17;
    const double w22 = w21 + w20;
    const double w23 = w[9][l] * w22;
    const double w24 = w23 * w[10][l];
    const double w25 = w1 * w[10][l];
    const double w26 = c[13][l] * w25;
    const double w27 = w24 + w26;
    const double w28 = lane_min(w27, w[12][l]);
    const double w29 = lane_max(w[21][l], w28);
    const double w30 = (-100000.0) * w29;
    const double w31 = w[22][l] + w30;
    const double w32 = lane_max(0.0, w31);
    const double w33 = w32 * w32;
    const double w34 = w32 * w33;
    const double w35 = (-0.5) * w32;
    const double w36 = w35 + 1.0;
    const double w37 = w34 * w36;
    const double w38 = 100000.0 * w29;
    const double w39 = w[22][l] + w38;
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
    const double w50 = w[7][l] * w49;
    const double w51 = w50 * w[8][l];
    const double w52 = c[67][l] * w51;
    const double w53 = w[23][l] + w52;
    const double w54 = lane_sin(w[32][l]);
    const double w55 = w54 * w[33][l];
    const double w56 = w[24][l] * w55;
    const double w57 = w56 * w[34][l];
    const double w58 = c[13][l] * w57;
    const double w59 = w58 + 1e-12;
    const double w60 = w59 * w[35][l];
    const double w61 = (-50.0) * w60;
    const double w62 = w61 + c[77][l];
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
    const double w73 = w72 + c[78][l];
    const double w74 = lane_max(0.0, w73);
    const double w75 = 0.02 * w71;
    const double w76 = w75 + w74;
    const double w77 = w[24][l] * w76;
    const double w78 = w77 * w[25][l];
    const double w79 = w55 * w[25][l];
    const double w80 = c[13][l] * w79;
    const double w81 = w78 + w80;
    const double w82 = lane_min(w81, w[27][l]);
    const double w83 = lane_max(w[36][l], w82);
    const double w84 = (-100000.0) * w83;
    const double w85 = w[37][l] + w84;
    const double w86 = lane_max(0.0, w85);
    const double w87 = w86 * w86;
    const double w88 = w86 * w87;
    const double w89 = (-0.5) * w86;
    const double w90 = w89 + 1.0;
    const double w91 = w88 * w90;
    const double w92 = 100000.0 * w83;
    const double w93 = w[37][l] + w92;
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
    const double w104 = w[7][l] * w103;
    const double w105 = w104 * w[8][l];
    const double w106 = c[79][l] * w105;
    const double w107 = w[38][l] + w106;
    const double w108 = lane_sin(w[48][l]);
    const double w109 = w108 * w[49][l];
    const double w110 = w109 * w[41][l];
    const double w111 = c[22][l] * w110;
    const double w112 = lane_min(w111, w[43][l]);
    const double w113 = lane_max(w[50][l], w112);
    const double w114 = (-100000.0) * w113;
    const double w115 = w[51][l] + w114;
    const double w116 = lane_max(0.0, w115);
    const double w117 = w116 * w116;
    const double w118 = w116 * w117;
    const double w119 = (-0.5) * w116;
    const double w120 = w119 + 1.0;
    const double w121 = w118 * w120;
    const double w122 = 100000.0 * w113;
    const double w123 = w[51][l] + w122;
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
    const double w134 = w[39][l] * w133;
    const double w135 = w134 * w[40][l];
    const double w136 = c[95][l] * w53;
    const double w137 = w[53][l] + w136;
    const double w138 = c[96][l] * w107;
    const double w139 = w137 + w138;
    const double w140 = c[97][l] * w135;
    const double w141 = w139 + w140;
    const double w142 = c[68][l] * w51;
    const double w143 = w[56][l] + w142;
    const double w144 = c[111][l] * w105;
    const double w145 = w[57][l] + w144;
    const double w146 = c[113][l] * w135;
    const double w147 = w[58][l] + w146;
    const double w148 = c[96][l] * w143;
    const double w149 = w[60][l] + w148;
    const double w150 = c[95][l] * w145;
    const double w151 = w149 + w150;
    const double w152 = c[96][l] * w147;
    const double w153 = w151 + w152;
    const double w154 = c[126][l] * w53;
    const double w155 = w[62][l] + w154;
    const double w156 = c[126][l] * w107;
    const double w157 = w155 + w156;
    const double w158 = c[127][l] * w143;
    const double w159 = w157 + w158;
    const double w160 = c[128][l] * w145;
    const double w161 = w159 + w160;
    const double w162 = c[129][l] * w147;
    const double w163 = w161 + w162;
    WRITE(f, S0, w141);
    WRITE(f, S1, w153);
    WRITE(f, S2, w163);
}

APART void rates(const lanes *c, const lanes *u, const lanes *x, lanes *f)
{
    lanes w[63];
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
    const double w9 = w8 + 1e-06;
    const double w10 = sqrt(w9);
    const double w11 = w7 * w10;
    const double w12 = w11 + c[31][l];
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
    const double w29 = w8 + 1e-08;
    const double w30 = c[1][l] * w1;
    const double w31 = c[37][l] * w2;
    const double w32 = w30 + w31;
    const double w33 = -w32;
    const double w34 = x1 + w33;
    const double w35 = w34 * w34;
    const double w36 = w29 + w35;
    const double w37 = w36 * w7;
    const double w38 = sqrt(w29);
    const double w39 = 1.0 / w38;
    const double w40 = w37 * w39;
    const double w41 = c[40][l] * w40;
    const double w42 = w41 + c[27][l];
    const double w43 = c[43][l] * w36;
    const double w44 = w43 + c[44][l];
    const double w45 = c[45][l] * x2;
    const double w46 = x1 + w45;
    const double w47 = c[54][l] * x0;
    const double w48 = c[55][l] * x2;
    const double w49 = w47 + w48;
    const double w50 = c[52][l] * w46;
    const double w51 = w49 + w50;
    const double w52 = w51 * w51;
    const double w53 = c[57][l] * x0;
    const double w54 = c[58][l] * x2;
    const double w55 = w53 + w54;
    const double w56 = c[54][l] * w46;
    const double w57 = w55 + w56;
    const double w58 = w57 * w57;
    const double w59 = w52 + w58;
    const double w60 = w59 * w59;
    const double w61 = w60 + c[56][l];
    const double w62 = sqrt(w61);
    const double w63 = sqrt(w62);
    const double w64 = 1.0 / w63;
    const double w65 = w51 * w64;
    const double w66 = w52 + c[63][l];
    const double w67 = sqrt(w66);
    const double w68 = 1.0 / w67;
    const double w69 = w57 * w68;
    const double w70 = w58 + w66;
    const double w71 = sqrt(w70);
    const double w72 = 1.0 / w62;
    const double w73 = w58 * w72;
    const double w74 = w73 + 5e-13;
    const double w75 = 1.0 / w74;
    const double w76 = c[73][l] * x2;
    const double w77 = w47 + w76;
    const double w78 = c[57][l] * w46;
    const double w79 = w77 + w78;
    const double w80 = w79 * w79;
    const double w81 = c[52][l] * x0;
    const double w82 = c[74][l] * x2;
    const double w83 = w81 + w82;
    const double w84 = w83 + w56;
    const double w85 = w84 * w84;
    const double w86 = w80 + w85;
    const double w87 = w86 * w86;
    const double w88 = w87 + c[56][l];
    const double w89 = sqrt(w88);
    const double w90 = sqrt(w89);
    const double w91 = 1.0 / w90;
    const double w92 = w79 * w91;
    const double w93 = w80 + c[63][l];
    const double w94 = sqrt(w93);
    const double w95 = 1.0 / w94;
    const double w96 = w84 * w95;
    const double w97 = w85 + w93;
    const double w98 = sqrt(w97);
    const double w99 = 1.0 / w89;
    const double w100 = w85 * w99;
    const double w101 = w100 + 5e-13;
    const double w102 = 1.0 / w101;
    const double w103 = c[41][l] * x2;
    const double w104 = x1 + w103;
    const double w105 = c[82][l] * x0;
    const double w106 = c[83][l] * w104;
    const double w107 = w105 + w106;
    const double w108 = w107 * w107;
    const double w109 = c[84][l] * x0;
    const double w110 = c[82][l] * w104;
    const double w111 = w109 + w110;
    const double w112 = w111 * w111;
    const double w113 = w108 + w112;
    const double w114 = w113 * w113;
    const double w115 = w114 + c[56][l];
    const double w116 = sqrt(w115);
    const double w117 = sqrt(w116);
    const double w118 = 1.0 / w117;
    const double w119 = w107 * w118;
    const double w120 = w108 + c[63][l];
    const double w121 = sqrt(w120);
    const double w122 = 1.0 / w121;
    const double w123 = w111 * w122;
    const double w124 = w112 + w120;
    const double w125 = sqrt(w124);
    const double w126 = w0 + c[100][l];
    const double w127 = c[99][l] * w40;
    const double w128 = w126 + w127;
    const double w129 = c[103][l] * x2;
    const double w130 = x1 + w129;
    const double w131 = w130 + w33;
    const double w132 = w131 * w131;
    const double w133 = w27 + w132;
    const double w134 = sqrt(w36);
    const double w135 = w134 * x2;
    const double w136 = x2 * x0;
    const double w137 = -w136;
    const double w138 = w137 + c[117][l];
    const double w139 = c[115][l] * w135;
    const double w140 = w138 + w139;
    const double w141 = c[123][l] * w135;
    const double w142 = w141 + c[130][l];
    const double w143 = x0 * w1;
    const double w144 = x1 * w2;
    const double w145 = -w144;
    const double w146 = w143 + w145;
    const double w147 = x0 * w2;
    const double w148 = x1 * w1;
    const double w149 = w147 + w148;
    const double w150 = x1 * e2;
    const double w151 = x2 * e1;
    const double w152 = 0.0 <= w14 ? 1.0 : 0.0;
    const double w153 = w14 <= 0.0 ? 1.0 : 0.0;
    const double w154 = w152 + w153;
    const double w155 = 1.0 / w154;
    const double w156 = w152 * w155;
    const double w157 = w13 <= 1.0 ? 1.0 : 0.0;
    const double w158 = 1.0 <= w13 ? 1.0 : 0.0;
    const double w159 = w157 + w158;
    const double w160 = 1.0 / w159;
    const double w161 = w157 * w160;
    const double w162 = w1 * e5;
    const double w163 = w2 * e5;
    const double w164 = c[1][l] * w162;
    const double w165 = c[37][l] * w163;
    const double w166 = w164 + w165;
    const double w167 = -w166;
    const double w168 = e0 + w167;
    const double w169 = w10 * w168;
    const double w170 = w7 * w168;
    const double w171 = 1.0 / w10;
    const double w172 = w170 * w171;
    const double w173 = w7 * w172;
    const double w174 = w169 + w173;
    const double w175 = w161 * w174;
    const double w176 = w156 * w175;
    const double w177 = w16 * w176;
    const double w178 = w15 * w176;
    const double w179 = w15 * w178;
    const double w180 = 1000000.0 * w177;
    const double w181 = 2000000.0 * w179;
    const double w182 = w180 + w181;
    const double w183 = w21 * w182;
    const double w184 = (-8000000.0) * w176;
    const double w185 = 6000000.0 * w178;
    const double w186 = w184 + w185;
    const double w187 = w17 * w186;
    const double w188 = 0.0 <= w23 ? 1.0 : 0.0;
    const double w189 = w23 <= 0.0 ? 1.0 : 0.0;
    const double w190 = w188 + w189;
    const double w191 = 1.0 / w190;
    const double w192 = w188 * w191;
    const double w193 = w192 * w174;
    const double w194 = 1e-06 * w183;
    const double w195 = 1e-06 * w187;
    const double w196 = w194 + w195;
    const double w197 = w196 + w193;
    const double w198 = c[0][l] * w162;
    const double w199 = c[1][l] * w163;
    const double w200 = w198 + w199;
    const double w201 = e1 + w200;
    const double w202 = w34 * w201;
    const double w203 = 2.0 * w170;
    const double w204 = 2.0 * w202;
    const double w205 = w203 + w204;
    const double w206 = c[43][l] * w205;
    const double w207 = w7 * w205;
    const double w208 = w36 * w168;
    const double w209 = c[39][l] * w207;
    const double w210 = c[39][l] * w208;
    const double w211 = w209 + w210;
    const double w212 = w211 * w39;
    const double w213 = w40 * w39;
    const double w214 = w170 * w39;
    const double w215 = w213 * w214;
    const double w216 = c[40][l] * w215;
    const double w217 = w212 + w216;
    const double w218 = c[45][l] * e2;
    const double w219 = e1 + w218;
    const double w220 = c[54][l] * e0;
    const double w221 = c[55][l] * e2;
    const double w222 = w220 + w221;
    const double w223 = c[52][l] * w219;
    const double w224 = w222 + w223;
    const double w225 = w224 * w64;
    const double w226 = w65 * w64;
    const double w227 = w51 * w224;
    const double w228 = c[57][l] * e0;
    const double w229 = c[58][l] * e2;
    const double w230 = w228 + w229;
    const double w231 = c[54][l] * w219;
    const double w232 = w230 + w231;
    const double w233 = w57 * w232;
    const double w234 = 2.0 * w227;
    const double w235 = 2.0 * w233;
    const double w236 = w234 + w235;
    const double w237 = w59 * w236;
    const double w238 = w237 * w72;
    const double w239 = w238 * w64;
    const double w240 = w226 * w239;
    const double w241 = (-0.5) * w240;
    const double w242 = w225 + w241;
    const double w243 = w232 * w68;
    const double w244 = w69 * w68;
    const double w245 = w227 * w68;
    const double w246 = w244 * w245;
    const double w247 = -w246;
    const double w248 = w243 + w247;
    const double w249 = 1.0 / w71;
    const double w250 = w236 * w249;
    const double w251 = w233 * w72;
    const double w252 = w73 * w72;
    const double w253 = w252 * w238;
    const double w254 = 2.0 * w251;
    const double w255 = -w253;
    const double w256 = w254 + w255;
    const double w257 = c[73][l] * e2;
    const double w258 = w220 + w257;
    const double w259 = c[57][l] * w219;
    const double w260 = w258 + w259;
    const double w261 = w260 * w91;
    const double w262 = w92 * w91;
    const double w263 = w79 * w260;
    const double w264 = c[52][l] * e0;
    const double w265 = c[74][l] * e2;
    const double w266 = w264 + w265;
    const double w267 = w266 + w231;
    const double w268 = w84 * w267;
    const double w269 = 2.0 * w263;
    const double w270 = 2.0 * w268;
    const double w271 = w269 + w270;
    const double w272 = w86 * w271;
    const double w273 = w272 * w99;
    const double w274 = w273 * w91;
    const double w275 = w262 * w274;
    const double w276 = (-0.5) * w275;
    const double w277 = w261 + w276;
    const double w278 = w267 * w95;
    const double w279 = w96 * w95;
    const double w280 = w263 * w95;
    const double w281 = w279 * w280;
    const double w282 = -w281;
    const double w283 = w278 + w282;
    const double w284 = 1.0 / w98;
    const double w285 = w271 * w284;
    const double w286 = w268 * w99;
    const double w287 = w100 * w99;
    const double w288 = w287 * w273;
    const double w289 = 2.0 * w286;
    const double w290 = -w288;
    const double w291 = w289 + w290;
    const double w292 = c[41][l] * e2;
    const double w293 = e1 + w292;
    const double w294 = c[82][l] * e0;
    const double w295 = c[83][l] * w293;
    const double w296 = w294 + w295;
    const double w297 = w296 * w118;
    const double w298 = w119 * w118;
    const double w299 = w107 * w296;
    const double w300 = c[84][l] * e0;
    const double w301 = c[82][l] * w293;
    const double w302 = w300 + w301;
    const double w303 = w111 * w302;
    const double w304 = 2.0 * w299;
    const double w305 = 2.0 * w303;
    const double w306 = w304 + w305;
    const double w307 = w113 * w306;
    const double w308 = 1.0 / w116;
    const double w309 = w307 * w308;
    const double w310 = w309 * w118;
    const double w311 = w298 * w310;
    const double w312 = (-0.5) * w311;
    const double w313 = w297 + w312;
    const double w314 = w302 * w122;
    const double w315 = w123 * w122;
    const double w316 = w299 * w122;
    const double w317 = w315 * w316;
    const double w318 = -w317;
    const double w319 = w314 + w318;
    const double w320 = 1.0 / w125;
    const double w321 = w306 * w320;
    const double w322 = c[93][l] * w207;
    const double w323 = c[93][l] * w208;
    const double w324 = w322 + w323;
    const double w325 = w324 * w39;
    const double w326 = w150 + w151;
    const double w327 = c[178][l] * w215;
    const double w328 = w326 + w327;
    const double w329 = c[96][l] * w325;
    const double w330 = w328 + w329;
    const double w331 = 1.0 / w134;
    const double w332 = w205 * w331;
    const double w333 = x2 * w332;
    const double w334 = w134 * e2;
    const double w335 = c[179][l] * w333;
    const double w336 = c[108][l] * w334;
    const double w337 = w335 + w336;
    const double w338 = 1.0 / w36;
    const double w339 = w38 * w338;
    const double w340 = w339 * w201;
    const double w341 = w34 * w338;
    const double w342 = w341 * w214;
    const double w343 = -w342;
    const double w344 = w340 + w343;
    const double w345 = w36 * w344;
    const double w346 = 1.0 / w133;
    const double w347 = w28 * w346;
    const double w348 = c[103][l] * e2;
    const double w349 = e1 + w348;
    const double w350 = w349 + w200;
    const double w351 = w347 * w350;
    const double w352 = w131 * w346;
    const double w353 = 1.0 / w28;
    const double w354 = w197 * w353;
    const double w355 = w352 * w354;
    const double w356 = (-0.5) * w355;
    const double w357 = w351 + w356;
    const double w358 = w131 * w350;
    const double w359 = 2.0 * w358;
    const double w360 = w197 + w359;
    const double w361 = x0 * e2;
    const double w362 = x2 * e0;
    const double w363 = -w361;
    const double w364 = -w362;
    const double w365 = w363 + w364;
    const double w366 = c[185][l] * w337;
    const double w367 = w365 + w366;
    const double w368 = c[186][l] * w345;
    const double w369 = w367 + w368;
    const double w370 = c[187][l] * w337;
    const double w371 = c[188][l] * w345;
    const double w372 = w370 + w371;
    const double w373 = w1 * e0;
    const double w374 = x0 * w163;
    const double w375 = w2 * e1;
    const double w376 = x1 * w162;
    const double w377 = -w374;
    const double w378 = w373 + w377;
    const double w379 = -w375;
    const double w380 = w378 + w379;
    const double w381 = -w376;
    const double w382 = w380 + w381;
    const double w383 = w2 * e0;
    const double w384 = x0 * w162;
    const double w385 = w1 * e1;
    const double w386 = x1 * w163;
    const double w387 = w383 + w384;
    const double w388 = w387 + w385;
    const double w389 = -w386;
    const double w390 = w388 + w389;
    const double w391 = x1 * m2;
    const double w392 = x2 * m1;
    const double w393 = w1 * m5;
    const double w394 = w2 * m5;
    const double w395 = c[1][l] * w393;
    const double w396 = c[37][l] * w394;
    const double w397 = w395 + w396;
    const double w398 = -w397;
    const double w399 = m0 + w398;
    const double w400 = w10 * w399;
    const double w401 = w7 * w399;
    const double w402 = w401 * w171;
    const double w403 = w7 * w402;
    const double w404 = w400 + w403;
    const double w405 = w161 * w404;
    const double w406 = w156 * w405;
    const double w407 = w16 * w406;
    const double w408 = w15 * w406;
    const double w409 = w15 * w408;
    const double w410 = 1000000.0 * w407;
    const double w411 = 2000000.0 * w409;
    const double w412 = w410 + w411;
    const double w413 = w21 * w412;
    const double w414 = (-8000000.0) * w406;
    const double w415 = 6000000.0 * w408;
    const double w416 = w414 + w415;
    const double w417 = w17 * w416;
    const double w418 = w192 * w404;
    const double w419 = 1e-06 * w413;
    const double w420 = 1e-06 * w417;
    const double w421 = w419 + w420;
    const double w422 = w421 + w418;
    const double w423 = c[0][l] * w393;
    const double w424 = c[1][l] * w394;
    const double w425 = w423 + w424;
    const double w426 = m1 + w425;
    const double w427 = w34 * w426;
    const double w428 = 2.0 * w401;
    const double w429 = 2.0 * w427;
    const double w430 = w428 + w429;
    const double w431 = c[43][l] * w430;
    const double w432 = w7 * w430;
    const double w433 = w36 * w399;
    const double w434 = c[39][l] * w432;
    const double w435 = c[39][l] * w433;
    const double w436 = w434 + w435;
    const double w437 = w436 * w39;
    const double w438 = w401 * w39;
    const double w439 = w213 * w438;
    const double w440 = c[40][l] * w439;
    const double w441 = w437 + w440;
    const double w442 = c[45][l] * m2;
    const double w443 = m1 + w442;
    const double w444 = c[54][l] * m0;
    const double w445 = c[55][l] * m2;
    const double w446 = w444 + w445;
    const double w447 = c[52][l] * w443;
    const double w448 = w446 + w447;
    const double w449 = w448 * w64;
    const double w450 = w51 * w448;
    const double w451 = c[57][l] * m0;
    const double w452 = c[58][l] * m2;
    const double w453 = w451 + w452;
    const double w454 = c[54][l] * w443;
    const double w455 = w453 + w454;
    const double w456 = w57 * w455;
    const double w457 = 2.0 * w450;
    const double w458 = 2.0 * w456;
    const double w459 = w457 + w458;
    const double w460 = w59 * w459;
    const double w461 = w460 * w72;
    const double w462 = w461 * w64;
    const double w463 = w226 * w462;
    const double w464 = (-0.5) * w463;
    const double w465 = w449 + w464;
    const double w466 = w455 * w68;
    const double w467 = w450 * w68;
    const double w468 = w244 * w467;
    const double w469 = -w468;
    const double w470 = w466 + w469;
    const double w471 = w459 * w249;
    const double w472 = w456 * w72;
    const double w473 = w252 * w461;
    const double w474 = 2.0 * w472;
    const double w475 = -w473;
    const double w476 = w474 + w475;
    const double w477 = c[73][l] * m2;
    const double w478 = w444 + w477;
    const double w479 = c[57][l] * w443;
    const double w480 = w478 + w479;
    const double w481 = w480 * w91;
    const double w482 = w79 * w480;
    const double w483 = c[52][l] * m0;
    const double w484 = c[74][l] * m2;
    const double w485 = w483 + w484;
    const double w486 = w485 + w454;
    const double w487 = w84 * w486;
    const double w488 = 2.0 * w482;
    const double w489 = 2.0 * w487;
    const double w490 = w488 + w489;
    const double w491 = w86 * w490;
    const double w492 = w491 * w99;
    const double w493 = w492 * w91;
    const double w494 = w262 * w493;
    const double w495 = (-0.5) * w494;
    const double w496 = w481 + w495;
    const double w497 = w486 * w95;
    const double w498 = w482 * w95;
    const double w499 = w279 * w498;
    const double w500 = -w499;
    const double w501 = w497 + w500;
    const double w502 = w490 * w284;
    const double w503 = w487 * w99;
    const double w504 = w287 * w492;
    const double w505 = 2.0 * w503;
    const double w506 = -w504;
    const double w507 = w505 + w506;
    const double w508 = c[41][l] * m2;
    const double w509 = m1 + w508;
    const double w510 = c[82][l] * m0;
    const double w511 = c[83][l] * w509;
    const double w512 = w510 + w511;
    const double w513 = w512 * w118;
    const double w514 = w107 * w512;
    const double w515 = c[84][l] * m0;
    const double w516 = c[82][l] * w509;
    const double w517 = w515 + w516;
    const double w518 = w111 * w517;
    const double w519 = 2.0 * w514;
    const double w520 = 2.0 * w518;
    const double w521 = w519 + w520;
    const double w522 = w113 * w521;
    const double w523 = w522 * w308;
    const double w524 = w523 * w118;
    const double w525 = w298 * w524;
    const double w526 = (-0.5) * w525;
    const double w527 = w513 + w526;
    const double w528 = w517 * w122;
    const double w529 = w514 * w122;
    const double w530 = w315 * w529;
    const double w531 = -w530;
    const double w532 = w528 + w531;
    const double w533 = w521 * w320;
    const double w534 = c[93][l] * w432;
    const double w535 = c[93][l] * w433;
    const double w536 = w534 + w535;
    const double w537 = w536 * w39;
    const double w538 = w391 + w392;
    const double w539 = c[178][l] * w439;
    const double w540 = w538 + w539;
    const double w541 = c[96][l] * w537;
    const double w542 = w540 + w541;
    const double w543 = w430 * w331;
    const double w544 = x2 * w543;
    const double w545 = w134 * m2;
    const double w546 = c[179][l] * w544;
    const double w547 = c[108][l] * w545;
    const double w548 = w546 + w547;
    const double w549 = w339 * w426;
    const double w550 = w341 * w438;
    const double w551 = -w550;
    const double w552 = w549 + w551;
    const double w553 = w36 * w552;
    const double w554 = c[103][l] * m2;
    const double w555 = m1 + w554;
    const double w556 = w555 + w425;
    const double w557 = w347 * w556;
    const double w558 = w422 * w353;
    const double w559 = w352 * w558;
    const double w560 = (-0.5) * w559;
    const double w561 = w557 + w560;
    const double w562 = w131 * w556;
    const double w563 = 2.0 * w562;
    const double w564 = w422 + w563;
    const double w565 = x0 * m2;
    const double w566 = x2 * m0;
    const double w567 = -w565;
    const double w568 = -w566;
    const double w569 = w567 + w568;
    const double w570 = c[185][l] * w548;
    const double w571 = w569 + w570;
    const double w572 = c[186][l] * w553;
    const double w573 = w571 + w572;
    const double w574 = c[187][l] * w548;
    const double w575 = c[188][l] * w553;
    const double w576 = w574 + w575;
    const double w577 = w1 * m0;
    const double w578 = x0 * w394;
    const double w579 = w2 * m1;
    const double w580 = x1 * w393;
    const double w581 = -w578;
    const double w582 = w577 + w581;
    const double w583 = -w579;
    const double w584 = w582 + w583;
    const double w585 = -w580;
    const double w586 = w584 + w585;
    const double w587 = w2 * m0;
    const double w588 = x0 * w393;
    const double w589 = w1 * m1;
    const double w590 = x1 * w394;
    const double w591 = w587 + w588;
    const double w592 = w591 + w589;
    const double w593 = -w590;
    const double w594 = w592 + w593;
    w[0][l] = w27;
    w[1][l] = w28;
    w[2][l] = w34;
    w[3][l] = w36;
    w[4][l] = w38;
    w[5][l] = w42;
    w[6][l] = w44;
    w[9][l] = w57;
    w[10][l] = w64;
    w[11][l] = w65;
    w[13][l] = w69;
    w[18][l] = w71;
    w[19][l] = w72;
    w[20][l] = w75;
    w[24][l] = w84;
    w[25][l] = w91;
    w[26][l] = w92;
    w[28][l] = w96;
    w[33][l] = w98;
    w[34][l] = w99;
    w[35][l] = w102;
    w[41][l] = w118;
    w[42][l] = w119;
    w[44][l] = w123;
    w[49][l] = w125;
    w[52][l] = w128;
    w[54][l] = w131;
    w[55][l] = w133;
    w[59][l] = w140;
    w[61][l] = w142;
    w[63][l] = w197;
    w[64][l] = w205;
    w[65][l] = w206;
    w[66][l] = w217;
    w[69][l] = w232;
    w[70][l] = w238;
    w[71][l] = w239;
    w[72][l] = w242;
    w[74][l] = w248;
    w[77][l] = w250;
    w[78][l] = w256;
    w[82][l] = w267;
    w[83][l] = w273;
    w[84][l] = w274;
    w[85][l] = w277;
    w[87][l] = w283;
    w[90][l] = w285;
    w[91][l] = w291;
    w[97][l] = w310;
    w[98][l] = w313;
    w[100][l] = w319;
    w[103][l] = w321;
    w[106][l] = w330;
    w[108][l] = w357;
    w[109][l] = w360;
    w[113][l] = w369;
    w[115][l] = w372;
    w[117][l] = w422;
    w[118][l] = w430;
    w[119][l] = w431;
    w[120][l] = w441;
    w[123][l] = w455;
    w[124][l] = w461;
    w[125][l] = w462;
    w[126][l] = w465;
    w[128][l] = w470;
    w[131][l] = w471;
    w[132][l] = w476;
    w[136][l] = w486;
    w[137][l] = w492;
    w[138][l] = w493;
    w[139][l] = w496;
    w[141][l] = w501;
    w[144][l] = w502;
    w[145][l] = w507;
    w[151][l] = w524;
    w[152][l] = w527;
    w[154][l] = w532;
    w[157][l] = w533;
    w[160][l] = w542;
    w[162][l] = w561;
    w[163][l] = w564;
    w[167][l] = w573;
    w[169][l] = w576;
    WRITE(f, S3, w146);
    WRITE(f, S4, w149);
    WRITE(f, S5, x2);
    WRITE(r, S3, w382);
    WRITE(r, S4, w390);
    WRITE(r, S5, e2);
    WRITE_MOVING(g, S3, w586);
    WRITE_MOVING(g, S4, w594);
    WRITE_MOVING(g, S5, m2);
}

INLINE void turn1(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan2(0.0, w[1][l]);
    const double w1 = c[30][l] * w0;
    const double w2 = w1 + c[32][l];
    const double w3 = c[5][l] * w2;
    const double w4 = lane_min(c[28][l], w3);
    const double w5 = lane_max(c[29][l], w4);
    const double w6 = (-5.0) * w5;
    const double w7 = w6 + c[33][l];
    const double w8 = lane_max(0.0, w7);
    const double w9 = w8 * w8;
    const double w10 = w8 * w9;
    const double w11 = (-0.5) * w8;
    const double w12 = w11 + 1.0;
    const double w13 = w10 * w12;
    const double w14 = 5.0 * w5;
    const double w15 = w14 + c[33][l];
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
    const double w27 = c[35][l] * w26;
    const double w28 = w[5][l] + w27;
    const double w29 = c[42][l] * w26;
    const double w30 = w[6][l] + w29;
    const double w31 = c[41][l] * w28;
    const double w32 = w31 + w30;
    const double w33 = c[48][l] * w32;
    const double w34 = lane_max(0.0, w33);
    const double w35 = c[9][l] * w34;
    const double w36 = w35 + c[8][l];
    const double w37 = lane_max(0.001, w36);
    const double w38 = 1.0 / w37;
    const double w39 = c[49][l] * w37;
    const double w40 = w39 + c[50][l];
    const double w41 = w40 * w38;
    const double w42 = c[51][l] * w41;
    const double w43 = w42 + 5e-06;
    const double w44 = lane_min(w43, w[11][l]);
    const double w45 = -w43;
    const double w46 = lane_max(w45, w44);
    const double w47 = c[59][l] * w41;
    const double w48 = w47 + 0.5;
    const double w49 = (-100000.0) * w46;
    const double w50 = w48 + w49;
    const double w51 = lane_max(0.0, w50);
    const double w52 = w51 * w51;
    const double w53 = w51 * w52;
    const double w54 = (-0.5) * w51;
    const double w55 = w54 + 1.0;
    const double w56 = w53 * w55;
    const double w57 = 100000.0 * w46;
    const double w58 = w48 + w57;
    const double w59 = lane_max(0.0, w58);
    const double w60 = w59 * w59;
    const double w61 = w59 * w60;
    const double w62 = (-0.5) * w59;
    const double w63 = w62 + 1.0;
    const double w64 = w61 * w63;
    const double w65 = 1e-05 * w56;
    const double w66 = w46 + w65;
    const double w67 = (-1e-05) * w64;
    const double w68 = w66 + w67;
    const double w69 = w68 * w68;
    const double w70 = -w69;
    const double w71 = w70 + 1.0;
    const double w72 = sqrt(w71);
    const double w73 = w72 + 5e-06;
    const double w74 = c[7][l] * w34;
    const double w75 = w74 + c[6][l];
    const double w76 = lane_max(0.0, w75);
    const double w77 = w76 * w[13][l];
    const double w78 = w77 * w38;
    const double w79 = c[51][l] * w78;
    const double w80 = lane_min(w79, c[61][l]);
    const double w81 = lane_max(c[62][l], w80);
    const double w82 = c[11][l] * w81;
    const double w83 = c[64][l] * w81;
    const double w84 = -w73;
    const double w85 = (-100000.0) * w72;
    const double w86 = w85 + 0.5;
    const double w87 = w34 * w68;
    const double w88 = w87 * w37;
    const double w89 = c[69][l] * w88;
    const double w90 = c[70][l] * w37;
    const double w91 = w90 + c[71][l];
    const double w92 = w91 * w38;
    const double w93 = c[72][l] * w92;
    const double w94 = w93 + 5e-06;
    const double w95 = lane_min(w94, w[26][l]);
    const double w96 = -w94;
    const double w97 = lane_max(w96, w95);
    const double w98 = c[75][l] * w92;
    const double w99 = w98 + 0.5;
    const double w100 = (-100000.0) * w97;
    const double w101 = w99 + w100;
    const double w102 = lane_max(0.0, w101);
    const double w103 = w102 * w102;
    const double w104 = w102 * w103;
    const double w105 = (-0.5) * w102;
    const double w106 = w105 + 1.0;
    const double w107 = w104 * w106;
    const double w108 = 100000.0 * w97;
    const double w109 = w99 + w108;
    const double w110 = lane_max(0.0, w109);
    const double w111 = w110 * w110;
    const double w112 = w110 * w111;
    const double w113 = (-0.5) * w110;
    const double w114 = w113 + 1.0;
    const double w115 = w112 * w114;
    const double w116 = 1e-05 * w107;
    const double w117 = w97 + w116;
    const double w118 = (-1e-05) * w115;
    const double w119 = w117 + w118;
    const double w120 = w34 * w119;
    const double w121 = w120 * w37;
    const double w122 = w119 * w119;
    const double w123 = -w122;
    const double w124 = w123 + 1.0;
    const double w125 = sqrt(w124);
    const double w126 = w125 + 5e-06;
    const double w127 = w76 * w[28][l];
    const double w128 = w127 * w38;
    const double w129 = c[72][l] * w128;
    const double w130 = lane_min(w129, c[61][l]);
    const double w131 = lane_max(c[62][l], w130);
    const double w132 = c[11][l] * w131;
    const double w133 = c[64][l] * w131;
    const double w134 = -w126;
    const double w135 = (-100000.0) * w125;
    const double w136 = w135 + 0.5;
    const double w137 = c[76][l] * w121;
    const double w138 = c[45][l] * w28;
    const double w139 = w138 + w30;
    const double w140 = c[47][l] * w139;
    const double w141 = lane_max(0.0, w140);
    const double w142 = c[18][l] * w141;
    const double w143 = w142 + c[17][l];
    const double w144 = lane_max(0.001, w143);
    const double w145 = 1.0 / w144;
    const double w146 = c[81][l] * w145;
    const double w147 = w146 + 5e-06;
    const double w148 = lane_min(w147, w[42][l]);
    const double w149 = -w147;
    const double w150 = lane_max(w149, w148);
    const double w151 = c[85][l] * w145;
    const double w152 = w151 + 0.5;
    const double w153 = (-100000.0) * w150;
    const double w154 = w152 + w153;
    const double w155 = lane_max(0.0, w154);
    const double w156 = w155 * w155;
    const double w157 = w155 * w156;
    const double w158 = (-0.5) * w155;
    const double w159 = w158 + 1.0;
    const double w160 = w157 * w159;
    const double w161 = 100000.0 * w150;
    const double w162 = w152 + w161;
    const double w163 = lane_max(0.0, w162);
    const double w164 = w163 * w163;
    const double w165 = w163 * w164;
    const double w166 = (-0.5) * w163;
    const double w167 = w166 + 1.0;
    const double w168 = w165 * w167;
    const double w169 = 1e-05 * w160;
    const double w170 = w150 + w169;
    const double w171 = (-1e-05) * w168;
    const double w172 = w170 + w171;
    const double w173 = w172 * w172;
    const double w174 = -w173;
    const double w175 = w174 + 1.0;
    const double w176 = sqrt(w175);
    const double w177 = w176 + 5e-06;
    const double w178 = c[16][l] * w141;
    const double w179 = w178 + c[15][l];
    const double w180 = lane_max(0.0, w179);
    const double w181 = w180 * w[44][l];
    const double w182 = w181 * w145;
    const double w183 = c[80][l] * w182;
    const double w184 = lane_min(w183, c[86][l]);
    const double w185 = lane_max(c[87][l], w184);
    const double w186 = c[20][l] * w185;
    const double w187 = c[89][l] * w185;
    const double w188 = -w177;
    const double w189 = (-100000.0) * w176;
    const double w190 = w189 + 0.5;
    const double w191 = w141 * w172;
    const double w192 = w191 * w144;
    const double w193 = c[98][l] * w192;
    const double w194 = w[52][l] + w193;
    const double w195 = lane_atan2(w[54][l], w[1][l]);
    const double w196 = w195 + c[104][l];
    const double w197 = c[26][l] * w196;
    const double w198 = lane_min(c[101][l], w197);
    const double w199 = lane_max(c[102][l], w198);
    const double w200 = (-5.0) * w199;
    const double w201 = w200 + c[105][l];
    const double w202 = lane_max(0.0, w201);
    const double w203 = w202 * w202;
    const double w204 = w202 * w203;
    const double w205 = (-0.5) * w202;
    const double w206 = w205 + 1.0;
    const double w207 = w204 * w206;
    const double w208 = 5.0 * w199;
    const double w209 = w208 + c[105][l];
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
    const double w220 = w219 * w[55][l];
    const double w221 = lane_atan2(w[2][l], w[4][l]);
    const double w222 = c[23][l] * w221;
    const double w223 = w222 + c[110][l];
    const double w224 = w[3][l] * w223;
    const double w225 = c[67][l] * w88;
    const double w226 = c[79][l] * w121;
    const double w227 = c[112][l] * w192;
    const double w228 = c[114][l] * w220;
    const double w229 = w[59][l] + w228;
    const double w230 = c[116][l] * w224;
    const double w231 = w229 + w230;
    const double w232 = c[25][l] * w221;
    const double w233 = w232 + c[119][l];
    const double w234 = w[3][l] * w233;
    const double w235 = c[125][l] * w220;
    const double w236 = w[61][l] + w235;
    const double w237 = c[124][l] * w234;
    const double w238 = w236 + w237;
    const double w239 = w45 <= w44 ? 1.0 : 0.0;
    const double w240 = w44 <= w45 ? 1.0 : 0.0;
    const double w241 = w239 + w240;
    const double w242 = 1.0 / w241;
    const double w243 = w239 * w242;
    const double w244 = w43 <= w[11][l] ? 1.0 : 0.0;
    const double w245 = w[11][l] <= w43 ? 1.0 : 0.0;
    const double w246 = w244 + w245;
    const double w247 = 1.0 / w246;
    const double w248 = w244 * w247;
    const double w249 = w41 * w38;
    const double w250 = 0.001 <= w36 ? 1.0 : 0.0;
    const double w251 = w36 <= 0.001 ? 1.0 : 0.0;
    const double w252 = w250 + w251;
    const double w253 = 1.0 / w252;
    const double w254 = w250 * w253;
    const double w255 = 0.0 <= w33 ? 1.0 : 0.0;
    const double w256 = w33 <= 0.0 ? 1.0 : 0.0;
    const double w257 = w255 + w256;
    const double w258 = 1.0 / w257;
    const double w259 = w255 * w258;
    const double w260 = w25 * w[63][l];
    const double w261 = c[42][l] * w260;
    const double w262 = w[65][l] + w261;
    const double w263 = c[34][l] * w260;
    const double w264 = w[66][l] + w263;
    const double w265 = c[46][l] * w264;
    const double w266 = w262 + w265;
    const double w267 = w259 * w266;
    const double w268 = w254 * w267;
    const double w269 = w249 * w268;
    const double w270 = w268 * w38;
    const double w271 = c[149][l] * w269;
    const double w272 = c[150][l] * w270;
    const double w273 = w271 + w272;
    const double w274 = w248 * w273;
    const double w275 = w245 * w247;
    const double w276 = w275 * w[72][l];
    const double w277 = w274 + w276;
    const double w278 = w243 * w277;
    const double w279 = w240 * w242;
    const double w280 = w279 * w273;
    const double w281 = -w280;
    const double w282 = w278 + w281;
    const double w283 = 0.0 <= w50 ? 1.0 : 0.0;
    const double w284 = w50 <= 0.0 ? 1.0 : 0.0;
    const double w285 = w283 + w284;
    const double w286 = 1.0 / w285;
    const double w287 = w283 * w286;
    const double w288 = (-100000.0) * w273;
    const double w289 = (-100000.0) * w282;
    const double w290 = w288 + w289;
    const double w291 = w287 * w290;
    const double w292 = w52 * w291;
    const double w293 = w51 * w291;
    const double w294 = w51 * w293;
    const double w295 = 2.0 * w294;
    const double w296 = w292 + w295;
    const double w297 = w55 * w296;
    const double w298 = w53 * w291;
    const double w299 = 0.0 <= w58 ? 1.0 : 0.0;
    const double w300 = w58 <= 0.0 ? 1.0 : 0.0;
    const double w301 = w299 + w300;
    const double w302 = 1.0 / w301;
    const double w303 = w299 * w302;
    const double w304 = 100000.0 * w282;
    const double w305 = w288 + w304;
    const double w306 = w303 * w305;
    const double w307 = w60 * w306;
    const double w308 = w59 * w306;
    const double w309 = w59 * w308;
    const double w310 = 2.0 * w309;
    const double w311 = w307 + w310;
    const double w312 = w63 * w311;
    const double w313 = w61 * w306;
    const double w314 = 1e-05 * w297;
    const double w315 = w282 + w314;
    const double w316 = (-5e-06) * w298;
    const double w317 = w315 + w316;
    const double w318 = (-1e-05) * w312;
    const double w319 = w317 + w318;
    const double w320 = 5e-06 * w313;
    const double w321 = w319 + w320;
    const double w322 = w68 * w321;
    const double w323 = 1.0 / w72;
    const double w324 = w322 * w323;
    const double w325 = c[62][l] <= w80 ? 1.0 : 0.0;
    const double w326 = w80 <= c[62][l] ? 1.0 : 0.0;
    const double w327 = w325 + w326;
    const double w328 = 1.0 / w327;
    const double w329 = w325 * w328;
    const double w330 = w79 <= c[61][l] ? 1.0 : 0.0;
    const double w331 = c[61][l] <= w79 ? 1.0 : 0.0;
    const double w332 = w330 + w331;
    const double w333 = 1.0 / w332;
    const double w334 = w330 * w333;
    const double w335 = w76 * w[74][l];
    const double w336 = 0.0 <= w75 ? 1.0 : 0.0;
    const double w337 = w75 <= 0.0 ? 1.0 : 0.0;
    const double w338 = w336 + w337;
    const double w339 = 1.0 / w338;
    const double w340 = w336 * w339;
    const double w341 = w340 * w267;
    const double w342 = w[13][l] * w341;
    const double w343 = c[152][l] * w342;
    const double w344 = w335 + w343;
    const double w345 = w344 * w38;
    const double w346 = w78 * w38;
    const double w347 = w346 * w268;
    const double w348 = c[51][l] * w345;
    const double w349 = c[149][l] * w347;
    const double w350 = w348 + w349;
    const double w351 = w334 * w350;
    const double w352 = w329 * w351;
    const double w353 = w81 * w81;
    const double w354 = c[153][l] * w353;
    const double w355 = w354 + 1.0;
    const double w356 = 1.0 / w355;
    const double w357 = w352 * w356;
    const double w358 = c[64][l] * w352;
    const double w359 = c[154][l] * w357;
    const double w360 = w358 + w359;
    const double w361 = (-100000.0) * w324;
    const double w362 = 100000.0 * w324;
    const double w363 = w34 * w321;
    const double w364 = w68 * w267;
    const double w365 = c[48][l] * w364;
    const double w366 = w363 + w365;
    const double w367 = w37 * w366;
    const double w368 = w87 * w268;
    const double w369 = c[10][l] * w367;
    const double w370 = c[159][l] * w368;
    const double w371 = w369 + w370;
    const double w372 = c[160][l] * w371;
    const double w373 = w96 <= w95 ? 1.0 : 0.0;
    const double w374 = w95 <= w96 ? 1.0 : 0.0;
    const double w375 = w373 + w374;
    const double w376 = 1.0 / w375;
    const double w377 = w373 * w376;
    const double w378 = w94 <= w[26][l] ? 1.0 : 0.0;
    const double w379 = w[26][l] <= w94 ? 1.0 : 0.0;
    const double w380 = w378 + w379;
    const double w381 = 1.0 / w380;
    const double w382 = w378 * w381;
    const double w383 = w92 * w38;
    const double w384 = w383 * w268;
    const double w385 = c[162][l] * w270;
    const double w386 = c[161][l] * w384;
    const double w387 = w385 + w386;
    const double w388 = w382 * w387;
    const double w389 = w379 * w381;
    const double w390 = w389 * w[85][l];
    const double w391 = w388 + w390;
    const double w392 = w377 * w391;
    const double w393 = w374 * w376;
    const double w394 = w393 * w387;
    const double w395 = -w394;
    const double w396 = w392 + w395;
    const double w397 = 0.0 <= w101 ? 1.0 : 0.0;
    const double w398 = w101 <= 0.0 ? 1.0 : 0.0;
    const double w399 = w397 + w398;
    const double w400 = 1.0 / w399;
    const double w401 = w397 * w400;
    const double w402 = (-100000.0) * w387;
    const double w403 = (-100000.0) * w396;
    const double w404 = w402 + w403;
    const double w405 = w401 * w404;
    const double w406 = w103 * w405;
    const double w407 = w102 * w405;
    const double w408 = w102 * w407;
    const double w409 = 2.0 * w408;
    const double w410 = w406 + w409;
    const double w411 = w106 * w410;
    const double w412 = w104 * w405;
    const double w413 = 0.0 <= w109 ? 1.0 : 0.0;
    const double w414 = w109 <= 0.0 ? 1.0 : 0.0;
    const double w415 = w413 + w414;
    const double w416 = 1.0 / w415;
    const double w417 = w413 * w416;
    const double w418 = 100000.0 * w396;
    const double w419 = w402 + w418;
    const double w420 = w417 * w419;
    const double w421 = w111 * w420;
    const double w422 = w110 * w420;
    const double w423 = w110 * w422;
    const double w424 = 2.0 * w423;
    const double w425 = w421 + w424;
    const double w426 = w114 * w425;
    const double w427 = w112 * w420;
    const double w428 = 1e-05 * w411;
    const double w429 = w396 + w428;
    const double w430 = (-5e-06) * w412;
    const double w431 = w429 + w430;
    const double w432 = (-1e-05) * w426;
    const double w433 = w431 + w432;
    const double w434 = 5e-06 * w427;
    const double w435 = w433 + w434;
    const double w436 = w34 * w435;
    const double w437 = w119 * w267;
    const double w438 = c[48][l] * w437;
    const double w439 = w436 + w438;
    const double w440 = w37 * w439;
    const double w441 = w120 * w268;
    const double w442 = c[14][l] * w440;
    const double w443 = c[163][l] * w441;
    const double w444 = w442 + w443;
    const double w445 = w119 * w435;
    const double w446 = 1.0 / w125;
    const double w447 = w445 * w446;
    const double w448 = c[62][l] <= w130 ? 1.0 : 0.0;
    const double w449 = w130 <= c[62][l] ? 1.0 : 0.0;
    const double w450 = w448 + w449;
    const double w451 = 1.0 / w450;
    const double w452 = w448 * w451;
    const double w453 = w129 <= c[61][l] ? 1.0 : 0.0;
    const double w454 = c[61][l] <= w129 ? 1.0 : 0.0;
    const double w455 = w453 + w454;
    const double w456 = 1.0 / w455;
    const double w457 = w453 * w456;
    const double w458 = w76 * w[87][l];
    const double w459 = w[28][l] * w341;
    const double w460 = c[152][l] * w459;
    const double w461 = w458 + w460;
    const double w462 = w461 * w38;
    const double w463 = w128 * w38;
    const double w464 = w463 * w268;
    const double w465 = c[72][l] * w462;
    const double w466 = c[161][l] * w464;
    const double w467 = w465 + w466;
    const double w468 = w457 * w467;
    const double w469 = w452 * w468;
    const double w470 = w131 * w131;
    const double w471 = c[153][l] * w470;
    const double w472 = w471 + 1.0;
    const double w473 = 1.0 / w472;
    const double w474 = w469 * w473;
    const double w475 = c[64][l] * w469;
    const double w476 = c[154][l] * w474;
    const double w477 = w475 + w476;
    const double w478 = (-100000.0) * w447;
    const double w479 = 100000.0 * w447;
    const double w480 = c[54][l] * w444;
    const double w481 = 0.0 <= w140 ? 1.0 : 0.0;
    const double w482 = w140 <= 0.0 ? 1.0 : 0.0;
    const double w483 = w481 + w482;
    const double w484 = 1.0 / w483;
    const double w485 = w481 * w484;
    const double w486 = c[122][l] * w264;
    const double w487 = w262 + w486;
    const double w488 = w485 * w487;
    const double w489 = w148 <= w149 ? 1.0 : 0.0;
    const double w490 = w149 <= w148 ? 1.0 : 0.0;
    const double w491 = w489 + w490;
    const double w492 = 1.0 / w491;
    const double w493 = w489 * w492;
    const double w494 = w145 * w145;
    const double w495 = 0.001 <= w143 ? 1.0 : 0.0;
    const double w496 = w143 <= 0.001 ? 1.0 : 0.0;
    const double w497 = w495 + w496;
    const double w498 = 1.0 / w497;
    const double w499 = w495 * w498;
    const double w500 = w499 * w488;
    const double w501 = w494 * w500;
    const double w502 = w493 * w501;
    const double w503 = w490 * w492;
    const double w504 = w[42][l] <= w147 ? 1.0 : 0.0;
    const double w505 = w147 <= w[42][l] ? 1.0 : 0.0;
    const double w506 = w504 + w505;
    const double w507 = 1.0 / w506;
    const double w508 = w504 * w507;
    const double w509 = w508 * w[98][l];
    const double w510 = w505 * w507;
    const double w511 = w510 * w501;
    const double w512 = c[166][l] * w511;
    const double w513 = w509 + w512;
    const double w514 = w503 * w513;
    const double w515 = c[165][l] * w502;
    const double w516 = w515 + w514;
    const double w517 = 0.0 <= w154 ? 1.0 : 0.0;
    const double w518 = w154 <= 0.0 ? 1.0 : 0.0;
    const double w519 = w517 + w518;
    const double w520 = 1.0 / w519;
    const double w521 = w517 * w520;
    const double w522 = c[167][l] * w501;
    const double w523 = 100000.0 * w516;
    const double w524 = w522 + w523;
    const double w525 = w521 * w524;
    const double w526 = w157 * w525;
    const double w527 = w156 * w525;
    const double w528 = w155 * w525;
    const double w529 = w155 * w528;
    const double w530 = 2.0 * w529;
    const double w531 = w527 + w530;
    const double w532 = w159 * w531;
    const double w533 = 0.0 <= w162 ? 1.0 : 0.0;
    const double w534 = w162 <= 0.0 ? 1.0 : 0.0;
    const double w535 = w533 + w534;
    const double w536 = 1.0 / w535;
    const double w537 = w533 * w536;
    const double w538 = c[168][l] * w501;
    const double w539 = w538 + w523;
    const double w540 = w537 * w539;
    const double w541 = w164 * w540;
    const double w542 = w163 * w540;
    const double w543 = w163 * w542;
    const double w544 = 2.0 * w543;
    const double w545 = w541 + w544;
    const double w546 = w167 * w545;
    const double w547 = w165 * w540;
    const double w548 = 5e-06 * w526;
    const double w549 = w516 + w548;
    const double w550 = (-1e-05) * w532;
    const double w551 = w549 + w550;
    const double w552 = (-1e-05) * w546;
    const double w553 = w551 + w552;
    const double w554 = 5e-06 * w547;
    const double w555 = w553 + w554;
    const double w556 = w172 * w555;
    const double w557 = 1.0 / w176;
    const double w558 = w556 * w557;
    const double w559 = c[87][l] <= w184 ? 1.0 : 0.0;
    const double w560 = w184 <= c[87][l] ? 1.0 : 0.0;
    const double w561 = w559 + w560;
    const double w562 = 1.0 / w561;
    const double w563 = w559 * w562;
    const double w564 = w183 <= c[86][l] ? 1.0 : 0.0;
    const double w565 = c[86][l] <= w183 ? 1.0 : 0.0;
    const double w566 = w564 + w565;
    const double w567 = 1.0 / w566;
    const double w568 = w564 * w567;
    const double w569 = 0.0 <= w179 ? 1.0 : 0.0;
    const double w570 = w179 <= 0.0 ? 1.0 : 0.0;
    const double w571 = w569 + w570;
    const double w572 = 1.0 / w571;
    const double w573 = w569 * w572;
    const double w574 = w573 * w488;
    const double w575 = w[44][l] * w574;
    const double w576 = w180 * w[100][l];
    const double w577 = c[169][l] * w575;
    const double w578 = w577 + w576;
    const double w579 = w578 * w145;
    const double w580 = w182 * w145;
    const double w581 = w580 * w500;
    const double w582 = c[80][l] * w579;
    const double w583 = c[170][l] * w581;
    const double w584 = w582 + w583;
    const double w585 = w568 * w584;
    const double w586 = w563 * w585;
    const double w587 = w185 * w185;
    const double w588 = c[171][l] * w587;
    const double w589 = w588 + 1.0;
    const double w590 = 1.0 / w589;
    const double w591 = w586 * w590;
    const double w592 = c[89][l] * w586;
    const double w593 = c[172][l] * w591;
    const double w594 = w592 + w593;
    const double w595 = (-100000.0) * w558;
    const double w596 = 100000.0 * w558;
    const double w597 = w172 * w488;
    const double w598 = w141 * w555;
    const double w599 = c[47][l] * w597;
    const double w600 = w599 + w598;
    const double w601 = w144 * w600;
    const double w602 = w191 * w500;
    const double w603 = c[19][l] * w601;
    const double w604 = c[164][l] * w602;
    const double w605 = w603 + w604;
    const double w606 = c[177][l] * w605;
    const double w607 = w[106][l] + w606;
    const double w608 = w223 * w[64][l];
    const double w609 = c[102][l] <= w198 ? 1.0 : 0.0;
    const double w610 = w198 <= c[102][l] ? 1.0 : 0.0;
    const double w611 = w609 + w610;
    const double w612 = 1.0 / w611;
    const double w613 = w609 * w612;
    const double w614 = w197 <= c[101][l] ? 1.0 : 0.0;
    const double w615 = c[101][l] <= w197 ? 1.0 : 0.0;
    const double w616 = w614 + w615;
    const double w617 = 1.0 / w616;
    const double w618 = w614 * w617;
    const double w619 = w618 * w[108][l];
    const double w620 = w613 * w619;
    const double w621 = 0.0 <= w201 ? 1.0 : 0.0;
    const double w622 = w201 <= 0.0 ? 1.0 : 0.0;
    const double w623 = w621 + w622;
    const double w624 = 1.0 / w623;
    const double w625 = w621 * w624;
    const double w626 = w625 * w620;
    const double w627 = w204 * w626;
    const double w628 = w203 * w626;
    const double w629 = w202 * w626;
    const double w630 = w202 * w629;
    const double w631 = c[180][l] * w628;
    const double w632 = c[182][l] * w630;
    const double w633 = w631 + w632;
    const double w634 = w206 * w633;
    const double w635 = 0.0 <= w209 ? 1.0 : 0.0;
    const double w636 = w209 <= 0.0 ? 1.0 : 0.0;
    const double w637 = w635 + w636;
    const double w638 = 1.0 / w637;
    const double w639 = w635 * w638;
    const double w640 = w639 * w620;
    const double w641 = w211 * w640;
    const double w642 = w210 * w640;
    const double w643 = w210 * w642;
    const double w644 = c[180][l] * w641;
    const double w645 = c[182][l] * w643;
    const double w646 = w644 + w645;
    const double w647 = w214 * w646;
    const double w648 = w212 * w640;
    const double w649 = c[26][l] * w620;
    const double w650 = c[181][l] * w627;
    const double w651 = w649 + w650;
    const double w652 = (-0.2) * w634;
    const double w653 = w651 + w652;
    const double w654 = (-0.2) * w647;
    const double w655 = w653 + w654;
    const double w656 = c[183][l] * w648;
    const double w657 = w655 + w656;
    const double w658 = w[55][l] * w657;
    const double w659 = w219 * w[109][l];
    const double w660 = c[106][l] * w658;
    const double w661 = c[106][l] * w659;
    const double w662 = w660 + w661;
    const double w663 = c[52][l] * w371;
    const double w664 = c[52][l] * w444;
    const double w665 = c[83][l] * w605;
    const double w666 = c[116][l] * w608;
    const double w667 = w[113][l] + w666;
    const double w668 = c[96][l] * w662;
    const double w669 = w667 + w668;
    const double w670 = w233 * w[64][l];
    const double w671 = c[189][l] * w662;
    const double w672 = w[115][l] + w671;
    const double w673 = c[124][l] * w670;
    const double w674 = w672 + w673;
    const double w675 = w25 * w[117][l];
    const double w676 = c[42][l] * w675;
    const double w677 = w[119][l] + w676;
    const double w678 = c[34][l] * w675;
    const double w679 = w[120][l] + w678;
    const double w680 = c[46][l] * w679;
    const double w681 = w677 + w680;
    const double w682 = w259 * w681;
    const double w683 = w254 * w682;
    const double w684 = w249 * w683;
    const double w685 = w683 * w38;
    const double w686 = c[149][l] * w684;
    const double w687 = c[150][l] * w685;
    const double w688 = w686 + w687;
    const double w689 = w248 * w688;
    const double w690 = w275 * w[126][l];
    const double w691 = w689 + w690;
    const double w692 = w243 * w691;
    const double w693 = w279 * w688;
    const double w694 = -w693;
    const double w695 = w692 + w694;
    const double w696 = (-100000.0) * w688;
    const double w697 = (-100000.0) * w695;
    const double w698 = w696 + w697;
    const double w699 = w287 * w698;
    const double w700 = w52 * w699;
    const double w701 = w51 * w699;
    const double w702 = w51 * w701;
    const double w703 = 2.0 * w702;
    const double w704 = w700 + w703;
    const double w705 = w55 * w704;
    const double w706 = w53 * w699;
    const double w707 = 100000.0 * w695;
    const double w708 = w696 + w707;
    const double w709 = w303 * w708;
    const double w710 = w60 * w709;
    const double w711 = w59 * w709;
    const double w712 = w59 * w711;
    const double w713 = 2.0 * w712;
    const double w714 = w710 + w713;
    const double w715 = w63 * w714;
    const double w716 = w61 * w709;
    const double w717 = 1e-05 * w705;
    const double w718 = w695 + w717;
    const double w719 = (-5e-06) * w706;
    const double w720 = w718 + w719;
    const double w721 = (-1e-05) * w715;
    const double w722 = w720 + w721;
    const double w723 = 5e-06 * w716;
    const double w724 = w722 + w723;
    const double w725 = w68 * w724;
    const double w726 = w725 * w323;
    const double w727 = w76 * w[128][l];
    const double w728 = w340 * w682;
    const double w729 = w[13][l] * w728;
    const double w730 = c[152][l] * w729;
    const double w731 = w727 + w730;
    const double w732 = w731 * w38;
    const double w733 = w346 * w683;
    const double w734 = c[51][l] * w732;
    const double w735 = c[149][l] * w733;
    const double w736 = w734 + w735;
    const double w737 = w334 * w736;
    const double w738 = w329 * w737;
    const double w739 = w738 * w356;
    const double w740 = c[64][l] * w738;
    const double w741 = c[154][l] * w739;
    const double w742 = w740 + w741;
    const double w743 = (-100000.0) * w726;
    const double w744 = 100000.0 * w726;
    const double w745 = w34 * w724;
    const double w746 = w68 * w682;
    const double w747 = c[48][l] * w746;
    const double w748 = w745 + w747;
    const double w749 = w37 * w748;
    const double w750 = w87 * w683;
    const double w751 = c[10][l] * w749;
    const double w752 = c[159][l] * w750;
    const double w753 = w751 + w752;
    const double w754 = c[160][l] * w753;
    const double w755 = w383 * w683;
    const double w756 = c[162][l] * w685;
    const double w757 = c[161][l] * w755;
    const double w758 = w756 + w757;
    const double w759 = w382 * w758;
    const double w760 = w389 * w[139][l];
    const double w761 = w759 + w760;
    const double w762 = w377 * w761;
    const double w763 = w393 * w758;
    const double w764 = -w763;
    const double w765 = w762 + w764;
    const double w766 = (-100000.0) * w758;
    const double w767 = (-100000.0) * w765;
    const double w768 = w766 + w767;
    const double w769 = w401 * w768;
    const double w770 = w103 * w769;
    const double w771 = w102 * w769;
    const double w772 = w102 * w771;
    const double w773 = 2.0 * w772;
    const double w774 = w770 + w773;
    const double w775 = w106 * w774;
    const double w776 = w104 * w769;
    const double w777 = 100000.0 * w765;
    const double w778 = w766 + w777;
    const double w779 = w417 * w778;
    const double w780 = w111 * w779;
    const double w781 = w110 * w779;
    const double w782 = w110 * w781;
    const double w783 = 2.0 * w782;
    const double w784 = w780 + w783;
    const double w785 = w114 * w784;
    const double w786 = w112 * w779;
    const double w787 = 1e-05 * w775;
    const double w788 = w765 + w787;
    const double w789 = (-5e-06) * w776;
    const double w790 = w788 + w789;
    const double w791 = (-1e-05) * w785;
    const double w792 = w790 + w791;
    const double w793 = 5e-06 * w786;
    const double w794 = w792 + w793;
    const double w795 = w34 * w794;
    const double w796 = w119 * w682;
    const double w797 = c[48][l] * w796;
    const double w798 = w795 + w797;
    const double w799 = w37 * w798;
    const double w800 = w120 * w683;
    const double w801 = c[14][l] * w799;
    const double w802 = c[163][l] * w800;
    const double w803 = w801 + w802;
    const double w804 = w119 * w794;
    const double w805 = w804 * w446;
    const double w806 = w76 * w[141][l];
    const double w807 = w[28][l] * w728;
    const double w808 = c[152][l] * w807;
    const double w809 = w806 + w808;
    const double w810 = w809 * w38;
    const double w811 = w463 * w683;
    const double w812 = c[72][l] * w810;
    const double w813 = c[161][l] * w811;
    const double w814 = w812 + w813;
    const double w815 = w457 * w814;
    const double w816 = w452 * w815;
    const double w817 = w816 * w473;
    const double w818 = c[64][l] * w816;
    const double w819 = c[154][l] * w817;
    const double w820 = w818 + w819;
    const double w821 = (-100000.0) * w805;
    const double w822 = 100000.0 * w805;
    const double w823 = c[54][l] * w803;
    const double w824 = c[122][l] * w679;
    const double w825 = w677 + w824;
    const double w826 = w485 * w825;
    const double w827 = w499 * w826;
    const double w828 = w494 * w827;
    const double w829 = w493 * w828;
    const double w830 = w508 * w[152][l];
    const double w831 = w510 * w828;
    const double w832 = c[166][l] * w831;
    const double w833 = w830 + w832;
    const double w834 = w503 * w833;
    const double w835 = c[165][l] * w829;
    const double w836 = w835 + w834;
    const double w837 = c[167][l] * w828;
    const double w838 = 100000.0 * w836;
    const double w839 = w837 + w838;
    const double w840 = w521 * w839;
    const double w841 = w157 * w840;
    const double w842 = w156 * w840;
    const double w843 = w155 * w840;
    const double w844 = w155 * w843;
    const double w845 = 2.0 * w844;
    const double w846 = w842 + w845;
    const double w847 = w159 * w846;
    const double w848 = c[168][l] * w828;
    const double w849 = w848 + w838;
    const double w850 = w537 * w849;
    const double w851 = w164 * w850;
    const double w852 = w163 * w850;
    const double w853 = w163 * w852;
    const double w854 = 2.0 * w853;
    const double w855 = w851 + w854;
    const double w856 = w167 * w855;
    const double w857 = w165 * w850;
    const double w858 = 5e-06 * w841;
    const double w859 = w836 + w858;
    const double w860 = (-1e-05) * w847;
    const double w861 = w859 + w860;
    const double w862 = (-1e-05) * w856;
    const double w863 = w861 + w862;
    const double w864 = 5e-06 * w857;
    const double w865 = w863 + w864;
    const double w866 = w172 * w865;
    const double w867 = w866 * w557;
    const double w868 = w573 * w826;
    const double w869 = w[44][l] * w868;
    const double w870 = w180 * w[154][l];
    const double w871 = c[169][l] * w869;
    const double w872 = w871 + w870;
    const double w873 = w872 * w145;
    const double w874 = w580 * w827;
    const double w875 = c[80][l] * w873;
    const double w876 = c[170][l] * w874;
    const double w877 = w875 + w876;
    const double w878 = w568 * w877;
    const double w879 = w563 * w878;
    const double w880 = w879 * w590;
    const double w881 = c[89][l] * w879;
    const double w882 = c[172][l] * w880;
    const double w883 = w881 + w882;
    const double w884 = (-100000.0) * w867;
    const double w885 = 100000.0 * w867;
    const double w886 = w172 * w826;
    const double w887 = w141 * w865;
    const double w888 = c[47][l] * w886;
    const double w889 = w888 + w887;
    const double w890 = w144 * w889;
    const double w891 = w191 * w827;
    const double w892 = c[19][l] * w890;
    const double w893 = c[164][l] * w891;
    const double w894 = w892 + w893;
    const double w895 = c[177][l] * w894;
    const double w896 = w[160][l] + w895;
    const double w897 = w223 * w[118][l];
    const double w898 = w618 * w[162][l];
    const double w899 = w613 * w898;
    const double w900 = w625 * w899;
    const double w901 = w204 * w900;
    const double w902 = w203 * w900;
    const double w903 = w202 * w900;
    const double w904 = w202 * w903;
    const double w905 = c[180][l] * w902;
    const double w906 = c[182][l] * w904;
    const double w907 = w905 + w906;
    const double w908 = w206 * w907;
    const double w909 = w639 * w899;
    const double w910 = w211 * w909;
    const double w911 = w210 * w909;
    const double w912 = w210 * w911;
    const double w913 = c[180][l] * w910;
    const double w914 = c[182][l] * w912;
    const double w915 = w913 + w914;
    const double w916 = w214 * w915;
    const double w917 = w212 * w909;
    const double w918 = c[26][l] * w899;
    const double w919 = c[181][l] * w901;
    const double w920 = w918 + w919;
    const double w921 = (-0.2) * w908;
    const double w922 = w920 + w921;
    const double w923 = (-0.2) * w916;
    const double w924 = w922 + w923;
    const double w925 = c[183][l] * w917;
    const double w926 = w924 + w925;
    const double w927 = w[55][l] * w926;
    const double w928 = w219 * w[163][l];
    const double w929 = c[106][l] * w927;
    const double w930 = c[106][l] * w928;
    const double w931 = w929 + w930;
    const double w932 = c[52][l] * w753;
    const double w933 = c[52][l] * w803;
    const double w934 = c[83][l] * w894;
    const double w935 = c[116][l] * w897;
    const double w936 = w[167][l] + w935;
    const double w937 = c[96][l] * w931;
    const double w938 = w936 + w937;
    const double w939 = w233 * w[118][l];
    const double w940 = c[189][l] * w931;
    const double w941 = w[169][l] + w940;
    const double w942 = c[124][l] * w939;
    const double w943 = w941 + w942;
    w[7][l] = w34;
    w[8][l] = w37;
    w[12][l] = w73;
    w[14][l] = w82;
    w[15][l] = w83;
    w[21][l] = w84;
    w[22][l] = w86;
    w[23][l] = w89;
    w[27][l] = w126;
    w[29][l] = w132;
    w[30][l] = w133;
    w[36][l] = w134;
    w[37][l] = w136;
    w[38][l] = w137;
    w[39][l] = w141;
    w[40][l] = w144;
    w[43][l] = w177;
    w[45][l] = w186;
    w[46][l] = w187;
    w[50][l] = w188;
    w[51][l] = w190;
    w[53][l] = w194;
    w[56][l] = w225;
    w[57][l] = w226;
    w[58][l] = w227;
    w[60][l] = w231;
    w[62][l] = w238;
    w[67][l] = w267;
    w[68][l] = w268;
    w[73][l] = w324;
    w[75][l] = w360;
    w[79][l] = w361;
    w[80][l] = w362;
    w[81][l] = w372;
    w[86][l] = w447;
    w[88][l] = w477;
    w[92][l] = w478;
    w[93][l] = w479;
    w[94][l] = w480;
    w[95][l] = w488;
    w[96][l] = w500;
    w[99][l] = w558;
    w[101][l] = w594;
    w[104][l] = w595;
    w[105][l] = w596;
    w[107][l] = w607;
    w[110][l] = w663;
    w[111][l] = w664;
    w[112][l] = w665;
    w[114][l] = w669;
    w[116][l] = w674;
    w[121][l] = w682;
    w[122][l] = w683;
    w[127][l] = w726;
    w[129][l] = w742;
    w[133][l] = w743;
    w[134][l] = w744;
    w[135][l] = w754;
    w[140][l] = w805;
    w[142][l] = w820;
    w[146][l] = w821;
    w[147][l] = w822;
    w[148][l] = w823;
    w[149][l] = w826;
    w[150][l] = w827;
    w[153][l] = w867;
    w[155][l] = w883;
    w[158][l] = w884;
    w[159][l] = w885;
    w[161][l] = w896;
    w[164][l] = w932;
    w[165][l] = w933;
    w[166][l] = w934;
    w[168][l] = w938;
    w[170][l] = w943;
}

INLINE void turn2(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[14][l]);
    const double w1 = c[65][l] * w0;
    const double w2 = w[15][l] + w1;
    const double w3 = c[11][l] * w2;
    const double w4 = lane_atan(w[29][l]);
    const double w5 = c[65][l] * w4;
    const double w6 = w[30][l] + w5;
    const double w7 = c[11][l] * w6;
    const double w8 = lane_atan(w[45][l]);
    const double w9 = c[88][l] * w8;
    const double w10 = w[46][l] + w9;
    const double w11 = c[20][l] * w10;
    const double w12 = w2 * w2;
    const double w13 = c[153][l] * w12;
    const double w14 = w13 + 1.0;
    const double w15 = 1.0 / w14;
    const double w16 = w[75][l] * w15;
    const double w17 = w6 * w6;
    const double w18 = c[153][l] * w17;
    const double w19 = w18 + 1.0;
    const double w20 = 1.0 / w19;
    const double w21 = w[88][l] * w20;
    const double w22 = w10 * w10;
    const double w23 = c[171][l] * w22;
    const double w24 = w23 + 1.0;
    const double w25 = 1.0 / w24;
    const double w26 = w[101][l] * w25;
    const double w27 = w[129][l] * w15;
    const double w28 = w[142][l] * w20;
    const double w29 = w[155][l] * w25;
    w[16][l] = w3;
    w[31][l] = w7;
    w[47][l] = w11;
    w[76][l] = w16;
    w[89][l] = w21;
    w[102][l] = w26;
    w[130][l] = w27;
    w[143][l] = w28;
    w[156][l] = w29;
}

INLINE void turn3(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_atan(w[16][l]);
    const double w1 = c[12][l] * w0;
    const double w2 = lane_atan(w[31][l]);
    const double w3 = c[12][l] * w2;
    const double w4 = lane_atan(w[47][l]);
    const double w5 = c[21][l] * w4;
    w[17][l] = w1;
    w[32][l] = w3;
    w[48][l] = w5;
}

INLINE void turn4(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g, lanes *w, int l)
{
    const double w0 = lane_sin(w[17][l]);
    const double w1 = w0 * w[18][l];
    const double w2 = w[9][l] * w1;
    const double w3 = w2 * w[19][l];
    const double w4 = c[13][l] * w3;
    const double w5 = w4 + 1e-12;
    const double w6 = w5 * w[20][l];
    const double w7 = (-50.0) * w6;
    const double w8 = w7 + c[60][l];
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
    const double w19 = w18 + c[66][l];
    const double w20 = lane_max(0.0, w19);
    const double w21 = 0.02 * w17;
    const double w22 = w21 + w20;
    const double w23 = w[9][l] * w22;
    const double w24 = w23 * w[10][l];
    const double w25 = w1 * w[10][l];
    const double w26 = c[13][l] * w25;
    const double w27 = w24 + w26;
    const double w28 = lane_min(w27, w[12][l]);
    const double w29 = lane_max(w[21][l], w28);
    const double w30 = (-100000.0) * w29;
    const double w31 = w[22][l] + w30;
    const double w32 = lane_max(0.0, w31);
    const double w33 = w32 * w32;
    const double w34 = w32 * w33;
    const double w35 = (-0.5) * w32;
    const double w36 = w35 + 1.0;
    const double w37 = w34 * w36;
    const double w38 = 100000.0 * w29;
    const double w39 = w[22][l] + w38;
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
    const double w50 = w[7][l] * w49;
    const double w51 = w50 * w[8][l];
    const double w52 = c[67][l] * w51;
    const double w53 = w[23][l] + w52;
    const double w54 = lane_sin(w[32][l]);
    const double w55 = w54 * w[33][l];
    const double w56 = w[24][l] * w55;
    const double w57 = w56 * w[34][l];
    const double w58 = c[13][l] * w57;
    const double w59 = w58 + 1e-12;
    const double w60 = w59 * w[35][l];
    const double w61 = (-50.0) * w60;
    const double w62 = w61 + c[77][l];
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
    const double w73 = w72 + c[78][l];
    const double w74 = lane_max(0.0, w73);
    const double w75 = 0.02 * w71;
    const double w76 = w75 + w74;
    const double w77 = w[24][l] * w76;
    const double w78 = w77 * w[25][l];
    const double w79 = w55 * w[25][l];
    const double w80 = c[13][l] * w79;
    const double w81 = w78 + w80;
    const double w82 = lane_min(w81, w[27][l]);
    const double w83 = lane_max(w[36][l], w82);
    const double w84 = (-100000.0) * w83;
    const double w85 = w[37][l] + w84;
    const double w86 = lane_max(0.0, w85);
    const double w87 = w86 * w86;
    const double w88 = w86 * w87;
    const double w89 = (-0.5) * w86;
    const double w90 = w89 + 1.0;
    const double w91 = w88 * w90;
    const double w92 = 100000.0 * w83;
    const double w93 = w[37][l] + w92;
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
    const double w104 = w[7][l] * w103;
    const double w105 = w104 * w[8][l];
    const double w106 = c[79][l] * w105;
    const double w107 = w[38][l] + w106;
    const double w108 = lane_sin(w[48][l]);
    const double w109 = w108 * w[49][l];
    const double w110 = w109 * w[41][l];
    const double w111 = c[22][l] * w110;
    const double w112 = lane_min(w111, w[43][l]);
    const double w113 = lane_max(w[50][l], w112);
    const double w114 = (-100000.0) * w113;
    const double w115 = w[51][l] + w114;
    const double w116 = lane_max(0.0, w115);
    const double w117 = w116 * w116;
    const double w118 = w116 * w117;
    const double w119 = (-0.5) * w116;
    const double w120 = w119 + 1.0;
    const double w121 = w118 * w120;
    const double w122 = 100000.0 * w113;
    const double w123 = w[51][l] + w122;
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
    const double w134 = w[39][l] * w133;
    const double w135 = w134 * w[40][l];
    const double w136 = c[95][l] * w53;
    const double w137 = w[53][l] + w136;
    const double w138 = c[96][l] * w107;
    const double w139 = w137 + w138;
    const double w140 = c[97][l] * w135;
    const double w141 = w139 + w140;
    const double w142 = c[68][l] * w51;
    const double w143 = w[56][l] + w142;
    const double w144 = c[111][l] * w105;
    const double w145 = w[57][l] + w144;
    const double w146 = c[113][l] * w135;
    const double w147 = w[58][l] + w146;
    const double w148 = c[96][l] * w143;
    const double w149 = w[60][l] + w148;
    const double w150 = c[95][l] * w145;
    const double w151 = w149 + w150;
    const double w152 = c[96][l] * w147;
    const double w153 = w151 + w152;
    const double w154 = c[126][l] * w53;
    const double w155 = w[62][l] + w154;
    const double w156 = c[126][l] * w107;
    const double w157 = w155 + w156;
    const double w158 = c[127][l] * w143;
    const double w159 = w157 + w158;
    const double w160 = c[128][l] * w145;
    const double w161 = w159 + w160;
    const double w162 = c[129][l] * w147;
    const double w163 = w161 + w162;
    const double w164 = w28 <= w[21][l] ? 1.0 : 0.0;
    const double w165 = w[21][l] <= w28 ? 1.0 : 0.0;
    const double w166 = w164 + w165;
    const double w167 = 1.0 / w166;
    const double w168 = w164 * w167;
    const double w169 = w168 * w[73][l];
    const double w170 = w165 * w167;
    const double w171 = w27 <= w[12][l] ? 1.0 : 0.0;
    const double w172 = w[12][l] <= w27 ? 1.0 : 0.0;
    const double w173 = w171 + w172;
    const double w174 = 1.0 / w173;
    const double w175 = w171 * w174;
    const double w176 = w22 * w[69][l];
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
    const double w187 = w1 * w[69][l];
    const double w188 = lane_cos(w[17][l]);
    const double w189 = w188 * w[76][l];
    const double w190 = w[18][l] * w189;
    const double w191 = w0 * w[77][l];
    const double w192 = c[155][l] * w190;
    const double w193 = c[156][l] * w191;
    const double w194 = w192 + w193;
    const double w195 = w[9][l] * w194;
    const double w196 = c[13][l] * w187;
    const double w197 = w196 + w195;
    const double w198 = w197 * w[19][l];
    const double w199 = w3 * w[19][l];
    const double w200 = w199 * w[70][l];
    const double w201 = c[157][l] * w200;
    const double w202 = w198 + w201;
    const double w203 = w202 * w[20][l];
    const double w204 = w6 * w[20][l];
    const double w205 = w204 * w[78][l];
    const double w206 = -w205;
    const double w207 = w203 + w206;
    const double w208 = w186 * w207;
    const double w209 = w181 * w208;
    const double w210 = w10 * w209;
    const double w211 = 400.0 * w209;
    const double w212 = (-300.0) * w210;
    const double w213 = w211 + w212;
    const double w214 = w12 * w213;
    const double w215 = w11 * w209;
    const double w216 = w10 * w210;
    const double w217 = 50.0 * w215;
    const double w218 = 100.0 * w216;
    const double w219 = w217 + w218;
    const double w220 = w16 * w219;
    const double w221 = 0.0 <= w19 ? 1.0 : 0.0;
    const double w222 = w19 <= 0.0 ? 1.0 : 0.0;
    const double w223 = w221 + w222;
    const double w224 = 1.0 / w223;
    const double w225 = w221 * w224;
    const double w226 = w225 * w207;
    const double w227 = 0.02 * w214;
    const double w228 = (-0.02) * w220;
    const double w229 = w227 + w228;
    const double w230 = -w226;
    const double w231 = w229 + w230;
    const double w232 = w[9][l] * w231;
    const double w233 = w176 + w232;
    const double w234 = w233 * w[10][l];
    const double w235 = w24 * w[10][l];
    const double w236 = w235 * w[71][l];
    const double w237 = w194 * w[10][l];
    const double w238 = w25 * w[10][l];
    const double w239 = w238 * w[71][l];
    const double w240 = (-0.5) * w236;
    const double w241 = w234 + w240;
    const double w242 = w241 + w237;
    const double w243 = c[158][l] * w239;
    const double w244 = w242 + w243;
    const double w245 = w175 * w244;
    const double w246 = w172 * w174;
    const double w247 = w246 * w[73][l];
    const double w248 = -w247;
    const double w249 = w245 + w248;
    const double w250 = w170 * w249;
    const double w251 = w169 + w250;
    const double w252 = 0.0 <= w31 ? 1.0 : 0.0;
    const double w253 = w31 <= 0.0 ? 1.0 : 0.0;
    const double w254 = w252 + w253;
    const double w255 = 1.0 / w254;
    const double w256 = w252 * w255;
    const double w257 = 100000.0 * w251;
    const double w258 = w[79][l] + w257;
    const double w259 = w256 * w258;
    const double w260 = w34 * w259;
    const double w261 = w33 * w259;
    const double w262 = w32 * w259;
    const double w263 = w32 * w262;
    const double w264 = 2.0 * w263;
    const double w265 = w261 + w264;
    const double w266 = w36 * w265;
    const double w267 = 0.0 <= w39 ? 1.0 : 0.0;
    const double w268 = w39 <= 0.0 ? 1.0 : 0.0;
    const double w269 = w267 + w268;
    const double w270 = 1.0 / w269;
    const double w271 = w267 * w270;
    const double w272 = w[80][l] + w257;
    const double w273 = w271 * w272;
    const double w274 = w41 * w273;
    const double w275 = w40 * w273;
    const double w276 = w40 * w275;
    const double w277 = 2.0 * w276;
    const double w278 = w274 + w277;
    const double w279 = w44 * w278;
    const double w280 = w42 * w273;
    const double w281 = 5e-06 * w260;
    const double w282 = w251 + w281;
    const double w283 = (-1e-05) * w266;
    const double w284 = w282 + w283;
    const double w285 = (-1e-05) * w279;
    const double w286 = w284 + w285;
    const double w287 = 5e-06 * w280;
    const double w288 = w286 + w287;
    const double w289 = w[7][l] * w288;
    const double w290 = w49 * w[67][l];
    const double w291 = c[48][l] * w290;
    const double w292 = w289 + w291;
    const double w293 = w[8][l] * w292;
    const double w294 = w50 * w[68][l];
    const double w295 = c[10][l] * w293;
    const double w296 = c[159][l] * w294;
    const double w297 = w295 + w296;
    const double w298 = c[52][l] * w297;
    const double w299 = w[81][l] + w298;
    const double w300 = w82 <= w[36][l] ? 1.0 : 0.0;
    const double w301 = w[36][l] <= w82 ? 1.0 : 0.0;
    const double w302 = w300 + w301;
    const double w303 = 1.0 / w302;
    const double w304 = w300 * w303;
    const double w305 = w304 * w[86][l];
    const double w306 = w301 * w303;
    const double w307 = w81 <= w[27][l] ? 1.0 : 0.0;
    const double w308 = w[27][l] <= w81 ? 1.0 : 0.0;
    const double w309 = w307 + w308;
    const double w310 = 1.0 / w309;
    const double w311 = w307 * w310;
    const double w312 = w76 * w[82][l];
    const double w313 = 0.0 <= w63 ? 1.0 : 0.0;
    const double w314 = w63 <= 0.0 ? 1.0 : 0.0;
    const double w315 = w313 + w314;
    const double w316 = 1.0 / w315;
    const double w317 = w313 * w316;
    const double w318 = w62 <= 1.0 ? 1.0 : 0.0;
    const double w319 = 1.0 <= w62 ? 1.0 : 0.0;
    const double w320 = w318 + w319;
    const double w321 = 1.0 / w320;
    const double w322 = w318 * w321;
    const double w323 = w55 * w[82][l];
    const double w324 = lane_cos(w[32][l]);
    const double w325 = w324 * w[89][l];
    const double w326 = w[33][l] * w325;
    const double w327 = w54 * w[90][l];
    const double w328 = c[155][l] * w326;
    const double w329 = c[156][l] * w327;
    const double w330 = w328 + w329;
    const double w331 = w[24][l] * w330;
    const double w332 = c[13][l] * w323;
    const double w333 = w332 + w331;
    const double w334 = w333 * w[34][l];
    const double w335 = w57 * w[34][l];
    const double w336 = w335 * w[83][l];
    const double w337 = c[157][l] * w336;
    const double w338 = w334 + w337;
    const double w339 = w338 * w[35][l];
    const double w340 = w60 * w[35][l];
    const double w341 = w340 * w[91][l];
    const double w342 = -w341;
    const double w343 = w339 + w342;
    const double w344 = w322 * w343;
    const double w345 = w317 * w344;
    const double w346 = w64 * w345;
    const double w347 = 400.0 * w345;
    const double w348 = (-300.0) * w346;
    const double w349 = w347 + w348;
    const double w350 = w66 * w349;
    const double w351 = w65 * w345;
    const double w352 = w64 * w346;
    const double w353 = 50.0 * w351;
    const double w354 = 100.0 * w352;
    const double w355 = w353 + w354;
    const double w356 = w70 * w355;
    const double w357 = 0.0 <= w73 ? 1.0 : 0.0;
    const double w358 = w73 <= 0.0 ? 1.0 : 0.0;
    const double w359 = w357 + w358;
    const double w360 = 1.0 / w359;
    const double w361 = w357 * w360;
    const double w362 = w361 * w343;
    const double w363 = 0.02 * w350;
    const double w364 = (-0.02) * w356;
    const double w365 = w363 + w364;
    const double w366 = -w362;
    const double w367 = w365 + w366;
    const double w368 = w[24][l] * w367;
    const double w369 = w312 + w368;
    const double w370 = w369 * w[25][l];
    const double w371 = w78 * w[25][l];
    const double w372 = w371 * w[84][l];
    const double w373 = w330 * w[25][l];
    const double w374 = w79 * w[25][l];
    const double w375 = w374 * w[84][l];
    const double w376 = (-0.5) * w372;
    const double w377 = w370 + w376;
    const double w378 = w377 + w373;
    const double w379 = c[158][l] * w375;
    const double w380 = w378 + w379;
    const double w381 = w311 * w380;
    const double w382 = w308 * w310;
    const double w383 = w382 * w[86][l];
    const double w384 = -w383;
    const double w385 = w381 + w384;
    const double w386 = w306 * w385;
    const double w387 = w305 + w386;
    const double w388 = 0.0 <= w85 ? 1.0 : 0.0;
    const double w389 = w85 <= 0.0 ? 1.0 : 0.0;
    const double w390 = w388 + w389;
    const double w391 = 1.0 / w390;
    const double w392 = w388 * w391;
    const double w393 = 100000.0 * w387;
    const double w394 = w[92][l] + w393;
    const double w395 = w392 * w394;
    const double w396 = w88 * w395;
    const double w397 = w87 * w395;
    const double w398 = w86 * w395;
    const double w399 = w86 * w398;
    const double w400 = 2.0 * w399;
    const double w401 = w397 + w400;
    const double w402 = w90 * w401;
    const double w403 = 0.0 <= w93 ? 1.0 : 0.0;
    const double w404 = w93 <= 0.0 ? 1.0 : 0.0;
    const double w405 = w403 + w404;
    const double w406 = 1.0 / w405;
    const double w407 = w403 * w406;
    const double w408 = w[93][l] + w393;
    const double w409 = w407 * w408;
    const double w410 = w95 * w409;
    const double w411 = w94 * w409;
    const double w412 = w94 * w411;
    const double w413 = 2.0 * w412;
    const double w414 = w410 + w413;
    const double w415 = w98 * w414;
    const double w416 = w96 * w409;
    const double w417 = 5e-06 * w396;
    const double w418 = w387 + w417;
    const double w419 = (-1e-05) * w402;
    const double w420 = w418 + w419;
    const double w421 = (-1e-05) * w415;
    const double w422 = w420 + w421;
    const double w423 = 5e-06 * w416;
    const double w424 = w422 + w423;
    const double w425 = w[7][l] * w424;
    const double w426 = w103 * w[67][l];
    const double w427 = c[48][l] * w426;
    const double w428 = w425 + w427;
    const double w429 = w[8][l] * w428;
    const double w430 = w104 * w[68][l];
    const double w431 = c[14][l] * w429;
    const double w432 = c[163][l] * w430;
    const double w433 = w431 + w432;
    const double w434 = c[52][l] * w433;
    const double w435 = w[94][l] + w434;
    const double w436 = w133 * w[95][l];
    const double w437 = w112 <= w[50][l] ? 1.0 : 0.0;
    const double w438 = w[50][l] <= w112 ? 1.0 : 0.0;
    const double w439 = w437 + w438;
    const double w440 = 1.0 / w439;
    const double w441 = w437 * w440;
    const double w442 = w441 * w[99][l];
    const double w443 = w438 * w440;
    const double w444 = w111 <= w[43][l] ? 1.0 : 0.0;
    const double w445 = w[43][l] <= w111 ? 1.0 : 0.0;
    const double w446 = w444 + w445;
    const double w447 = 1.0 / w446;
    const double w448 = w444 * w447;
    const double w449 = lane_cos(w[48][l]);
    const double w450 = w449 * w[102][l];
    const double w451 = w[49][l] * w450;
    const double w452 = w108 * w[103][l];
    const double w453 = c[173][l] * w451;
    const double w454 = c[174][l] * w452;
    const double w455 = w453 + w454;
    const double w456 = w455 * w[41][l];
    const double w457 = w110 * w[41][l];
    const double w458 = w457 * w[97][l];
    const double w459 = c[175][l] * w458;
    const double w460 = w456 + w459;
    const double w461 = w448 * w460;
    const double w462 = w445 * w447;
    const double w463 = w462 * w[99][l];
    const double w464 = -w463;
    const double w465 = w461 + w464;
    const double w466 = w443 * w465;
    const double w467 = w442 + w466;
    const double w468 = 0.0 <= w115 ? 1.0 : 0.0;
    const double w469 = w115 <= 0.0 ? 1.0 : 0.0;
    const double w470 = w468 + w469;
    const double w471 = 1.0 / w470;
    const double w472 = w468 * w471;
    const double w473 = 100000.0 * w467;
    const double w474 = w[104][l] + w473;
    const double w475 = w472 * w474;
    const double w476 = w118 * w475;
    const double w477 = w117 * w475;
    const double w478 = w116 * w475;
    const double w479 = w116 * w478;
    const double w480 = 2.0 * w479;
    const double w481 = w477 + w480;
    const double w482 = w120 * w481;
    const double w483 = 0.0 <= w123 ? 1.0 : 0.0;
    const double w484 = w123 <= 0.0 ? 1.0 : 0.0;
    const double w485 = w483 + w484;
    const double w486 = 1.0 / w485;
    const double w487 = w483 * w486;
    const double w488 = w[105][l] + w473;
    const double w489 = w487 * w488;
    const double w490 = w125 * w489;
    const double w491 = w124 * w489;
    const double w492 = w124 * w491;
    const double w493 = 2.0 * w492;
    const double w494 = w490 + w493;
    const double w495 = w128 * w494;
    const double w496 = w126 * w489;
    const double w497 = 5e-06 * w476;
    const double w498 = w467 + w497;
    const double w499 = (-1e-05) * w482;
    const double w500 = w498 + w499;
    const double w501 = (-1e-05) * w495;
    const double w502 = w500 + w501;
    const double w503 = 5e-06 * w496;
    const double w504 = w502 + w503;
    const double w505 = w[39][l] * w504;
    const double w506 = c[47][l] * w436;
    const double w507 = w506 + w505;
    const double w508 = w[40][l] * w507;
    const double w509 = w134 * w[96][l];
    const double w510 = c[19][l] * w508;
    const double w511 = c[164][l] * w509;
    const double w512 = w510 + w511;
    const double w513 = c[95][l] * w299;
    const double w514 = w[107][l] + w513;
    const double w515 = c[96][l] * w435;
    const double w516 = w514 + w515;
    const double w517 = c[176][l] * w512;
    const double w518 = w516 + w517;
    const double w519 = c[54][l] * w297;
    const double w520 = w[110][l] + w519;
    const double w521 = c[160][l] * w433;
    const double w522 = w[111][l] + w521;
    const double w523 = c[184][l] * w512;
    const double w524 = w[112][l] + w523;
    const double w525 = c[96][l] * w520;
    const double w526 = w[114][l] + w525;
    const double w527 = c[95][l] * w522;
    const double w528 = w526 + w527;
    const double w529 = c[96][l] * w524;
    const double w530 = w528 + w529;
    const double w531 = c[126][l] * w299;
    const double w532 = w[116][l] + w531;
    const double w533 = c[126][l] * w435;
    const double w534 = w532 + w533;
    const double w535 = c[127][l] * w520;
    const double w536 = w534 + w535;
    const double w537 = c[128][l] * w522;
    const double w538 = w536 + w537;
    const double w539 = c[129][l] * w524;
    const double w540 = w538 + w539;
    const double w541 = w168 * w[127][l];
    const double w542 = w22 * w[123][l];
    const double w543 = w1 * w[123][l];
    const double w544 = w188 * w[130][l];
    const double w545 = w[18][l] * w544;
    const double w546 = w0 * w[131][l];
    const double w547 = c[155][l] * w545;
    const double w548 = c[156][l] * w546;
    const double w549 = w547 + w548;
    const double w550 = w[9][l] * w549;
    const double w551 = c[13][l] * w543;
    const double w552 = w551 + w550;
    const double w553 = w552 * w[19][l];
    const double w554 = w199 * w[124][l];
    const double w555 = c[157][l] * w554;
    const double w556 = w553 + w555;
    const double w557 = w556 * w[20][l];
    const double w558 = w204 * w[132][l];
    const double w559 = -w558;
    const double w560 = w557 + w559;
    const double w561 = w186 * w560;
    const double w562 = w181 * w561;
    const double w563 = w10 * w562;
    const double w564 = 400.0 * w562;
    const double w565 = (-300.0) * w563;
    const double w566 = w564 + w565;
    const double w567 = w12 * w566;
    const double w568 = w11 * w562;
    const double w569 = w10 * w563;
    const double w570 = 50.0 * w568;
    const double w571 = 100.0 * w569;
    const double w572 = w570 + w571;
    const double w573 = w16 * w572;
    const double w574 = w225 * w560;
    const double w575 = 0.02 * w567;
    const double w576 = (-0.02) * w573;
    const double w577 = w575 + w576;
    const double w578 = -w574;
    const double w579 = w577 + w578;
    const double w580 = w[9][l] * w579;
    const double w581 = w542 + w580;
    const double w582 = w581 * w[10][l];
    const double w583 = w235 * w[125][l];
    const double w584 = w549 * w[10][l];
    const double w585 = w238 * w[125][l];
    const double w586 = (-0.5) * w583;
    const double w587 = w582 + w586;
    const double w588 = w587 + w584;
    const double w589 = c[158][l] * w585;
    const double w590 = w588 + w589;
    const double w591 = w175 * w590;
    const double w592 = w246 * w[127][l];
    const double w593 = -w592;
    const double w594 = w591 + w593;
    const double w595 = w170 * w594;
    const double w596 = w541 + w595;
    const double w597 = 100000.0 * w596;
    const double w598 = w[133][l] + w597;
    const double w599 = w256 * w598;
    const double w600 = w34 * w599;
    const double w601 = w33 * w599;
    const double w602 = w32 * w599;
    const double w603 = w32 * w602;
    const double w604 = 2.0 * w603;
    const double w605 = w601 + w604;
    const double w606 = w36 * w605;
    const double w607 = w[134][l] + w597;
    const double w608 = w271 * w607;
    const double w609 = w41 * w608;
    const double w610 = w40 * w608;
    const double w611 = w40 * w610;
    const double w612 = 2.0 * w611;
    const double w613 = w609 + w612;
    const double w614 = w44 * w613;
    const double w615 = w42 * w608;
    const double w616 = 5e-06 * w600;
    const double w617 = w596 + w616;
    const double w618 = (-1e-05) * w606;
    const double w619 = w617 + w618;
    const double w620 = (-1e-05) * w614;
    const double w621 = w619 + w620;
    const double w622 = 5e-06 * w615;
    const double w623 = w621 + w622;
    const double w624 = w[7][l] * w623;
    const double w625 = w49 * w[121][l];
    const double w626 = c[48][l] * w625;
    const double w627 = w624 + w626;
    const double w628 = w[8][l] * w627;
    const double w629 = w50 * w[122][l];
    const double w630 = c[10][l] * w628;
    const double w631 = c[159][l] * w629;
    const double w632 = w630 + w631;
    const double w633 = c[52][l] * w632;
    const double w634 = w[135][l] + w633;
    const double w635 = w304 * w[140][l];
    const double w636 = w76 * w[136][l];
    const double w637 = w55 * w[136][l];
    const double w638 = w324 * w[143][l];
    const double w639 = w[33][l] * w638;
    const double w640 = w54 * w[144][l];
    const double w641 = c[155][l] * w639;
    const double w642 = c[156][l] * w640;
    const double w643 = w641 + w642;
    const double w644 = w[24][l] * w643;
    const double w645 = c[13][l] * w637;
    const double w646 = w645 + w644;
    const double w647 = w646 * w[34][l];
    const double w648 = w335 * w[137][l];
    const double w649 = c[157][l] * w648;
    const double w650 = w647 + w649;
    const double w651 = w650 * w[35][l];
    const double w652 = w340 * w[145][l];
    const double w653 = -w652;
    const double w654 = w651 + w653;
    const double w655 = w322 * w654;
    const double w656 = w317 * w655;
    const double w657 = w64 * w656;
    const double w658 = 400.0 * w656;
    const double w659 = (-300.0) * w657;
    const double w660 = w658 + w659;
    const double w661 = w66 * w660;
    const double w662 = w65 * w656;
    const double w663 = w64 * w657;
    const double w664 = 50.0 * w662;
    const double w665 = 100.0 * w663;
    const double w666 = w664 + w665;
    const double w667 = w70 * w666;
    const double w668 = w361 * w654;
    const double w669 = 0.02 * w661;
    const double w670 = (-0.02) * w667;
    const double w671 = w669 + w670;
    const double w672 = -w668;
    const double w673 = w671 + w672;
    const double w674 = w[24][l] * w673;
    const double w675 = w636 + w674;
    const double w676 = w675 * w[25][l];
    const double w677 = w371 * w[138][l];
    const double w678 = w643 * w[25][l];
    const double w679 = w374 * w[138][l];
    const double w680 = (-0.5) * w677;
    const double w681 = w676 + w680;
    const double w682 = w681 + w678;
    const double w683 = c[158][l] * w679;
    const double w684 = w682 + w683;
    const double w685 = w311 * w684;
    const double w686 = w382 * w[140][l];
    const double w687 = -w686;
    const double w688 = w685 + w687;
    const double w689 = w306 * w688;
    const double w690 = w635 + w689;
    const double w691 = 100000.0 * w690;
    const double w692 = w[146][l] + w691;
    const double w693 = w392 * w692;
    const double w694 = w88 * w693;
    const double w695 = w87 * w693;
    const double w696 = w86 * w693;
    const double w697 = w86 * w696;
    const double w698 = 2.0 * w697;
    const double w699 = w695 + w698;
    const double w700 = w90 * w699;
    const double w701 = w[147][l] + w691;
    const double w702 = w407 * w701;
    const double w703 = w95 * w702;
    const double w704 = w94 * w702;
    const double w705 = w94 * w704;
    const double w706 = 2.0 * w705;
    const double w707 = w703 + w706;
    const double w708 = w98 * w707;
    const double w709 = w96 * w702;
    const double w710 = 5e-06 * w694;
    const double w711 = w690 + w710;
    const double w712 = (-1e-05) * w700;
    const double w713 = w711 + w712;
    const double w714 = (-1e-05) * w708;
    const double w715 = w713 + w714;
    const double w716 = 5e-06 * w709;
    const double w717 = w715 + w716;
    const double w718 = w[7][l] * w717;
    const double w719 = w103 * w[121][l];
    const double w720 = c[48][l] * w719;
    const double w721 = w718 + w720;
    const double w722 = w[8][l] * w721;
    const double w723 = w104 * w[122][l];
    const double w724 = c[14][l] * w722;
    const double w725 = c[163][l] * w723;
    const double w726 = w724 + w725;
    const double w727 = c[52][l] * w726;
    const double w728 = w[148][l] + w727;
    const double w729 = w133 * w[149][l];
    const double w730 = w441 * w[153][l];
    const double w731 = w449 * w[156][l];
    const double w732 = w[49][l] * w731;
    const double w733 = w108 * w[157][l];
    const double w734 = c[173][l] * w732;
    const double w735 = c[174][l] * w733;
    const double w736 = w734 + w735;
    const double w737 = w736 * w[41][l];
    const double w738 = w457 * w[151][l];
    const double w739 = c[175][l] * w738;
    const double w740 = w737 + w739;
    const double w741 = w448 * w740;
    const double w742 = w462 * w[153][l];
    const double w743 = -w742;
    const double w744 = w741 + w743;
    const double w745 = w443 * w744;
    const double w746 = w730 + w745;
    const double w747 = 100000.0 * w746;
    const double w748 = w[158][l] + w747;
    const double w749 = w472 * w748;
    const double w750 = w118 * w749;
    const double w751 = w117 * w749;
    const double w752 = w116 * w749;
    const double w753 = w116 * w752;
    const double w754 = 2.0 * w753;
    const double w755 = w751 + w754;
    const double w756 = w120 * w755;
    const double w757 = w[159][l] + w747;
    const double w758 = w487 * w757;
    const double w759 = w125 * w758;
    const double w760 = w124 * w758;
    const double w761 = w124 * w760;
    const double w762 = 2.0 * w761;
    const double w763 = w759 + w762;
    const double w764 = w128 * w763;
    const double w765 = w126 * w758;
    const double w766 = 5e-06 * w750;
    const double w767 = w746 + w766;
    const double w768 = (-1e-05) * w756;
    const double w769 = w767 + w768;
    const double w770 = (-1e-05) * w764;
    const double w771 = w769 + w770;
    const double w772 = 5e-06 * w765;
    const double w773 = w771 + w772;
    const double w774 = w[39][l] * w773;
    const double w775 = c[47][l] * w729;
    const double w776 = w775 + w774;
    const double w777 = w[40][l] * w776;
    const double w778 = w134 * w[150][l];
    const double w779 = c[19][l] * w777;
    const double w780 = c[164][l] * w778;
    const double w781 = w779 + w780;
    const double w782 = c[95][l] * w634;
    const double w783 = w[161][l] + w782;
    const double w784 = c[96][l] * w728;
    const double w785 = w783 + w784;
    const double w786 = c[176][l] * w781;
    const double w787 = w785 + w786;
    const double w788 = c[54][l] * w632;
    const double w789 = w[164][l] + w788;
    const double w790 = c[160][l] * w726;
    const double w791 = w[165][l] + w790;
    const double w792 = c[184][l] * w781;
    const double w793 = w[166][l] + w792;
    const double w794 = c[96][l] * w789;
    const double w795 = w[168][l] + w794;
    const double w796 = c[95][l] * w791;
    const double w797 = w795 + w796;
    const double w798 = c[96][l] * w793;
    const double w799 = w797 + w798;
    const double w800 = c[126][l] * w634;
    const double w801 = w[170][l] + w800;
    const double w802 = c[126][l] * w728;
    const double w803 = w801 + w802;
    const double w804 = c[127][l] * w789;
    const double w805 = w803 + w804;
    const double w806 = c[128][l] * w791;
    const double w807 = w805 + w806;
    const double w808 = c[129][l] * w793;
    const double w809 = w807 + w808;
    WRITE(f, S0, w141);
    WRITE(f, S1, w153);
    WRITE(f, S2, w163);
    WRITE(r, S0, w518);
    WRITE(r, S1, w530);
    WRITE(r, S2, w540);
    WRITE_MOVING(g, S0, w787);
    WRITE_MOVING(g, S1, w799);
    WRITE_MOVING(g, S2, w809);
}

APART void turns(const lanes *c, const lanes *u, const lanes *x, const lanes *e, const lanes *m, lanes *f, lanes *r, lanes *g)
{
    lanes w[171];
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
    const double w8 = w7 + 1e-06;
    const double w9 = sqrt(w8);
    const double w10 = w6 * w9;
    const double w11 = w10 + c[31][l];
    const double w12 = 1000000.0 * w11;
    const double w13 = lane_min(1.0, w12);
    const double w14 = lane_max(0.0, w13);
    const double w15 = w14 * w14;
    const double w16 = w14 * w15;
    const double w17 = (-8.0) * w14;
    const double w18 = w17 + 6.0;
    const double w19 = 3.0 * w15;
    const double w20 = w18 + w19;
    const double w21 = w16 * w20;
    const double w22 = w11 + (-1e-06);
    const double w23 = lane_max(0.0, w22);
    const double w24 = 1e-06 * w21;
    const double w25 = w24 + 1e-06;
    const double w26 = w25 + w23;
    const double w27 = sqrt(w26);
    const double w28 = lane_atan2(0.0, w27);
    const double w29 = c[30][l] * w28;
    const double w30 = w29 + c[32][l];
    const double w31 = c[5][l] * w30;
    const double w32 = lane_min(c[28][l], w31);
    const double w33 = lane_max(c[29][l], w32);
    const double w34 = (-5.0) * w33;
    const double w35 = w34 + c[33][l];
    const double w36 = lane_max(0.0, w35);
    const double w37 = w36 * w36;
    const double w38 = w36 * w37;
    const double w39 = (-0.5) * w36;
    const double w40 = w39 + 1.0;
    const double w41 = w38 * w40;
    const double w42 = 5.0 * w33;
    const double w43 = w42 + c[33][l];
    const double w44 = lane_max(0.0, w43);
    const double w45 = w44 * w44;
    const double w46 = w44 * w45;
    const double w47 = (-0.5) * w44;
    const double w48 = w47 + 1.0;
    const double w49 = w46 * w48;
    const double w50 = 0.2 * w41;
    const double w51 = w33 + w50;
    const double w52 = (-0.2) * w49;
    const double w53 = w51 + w52;
    const double w54 = w53 * w26;
    const double w55 = w7 + 1e-08;
    const double w56 = c[1][l] * w0;
    const double w57 = c[37][l] * w1;
    const double w58 = w56 + w57;
    const double w59 = -w58;
    const double w60 = x1 + w59;
    const double w61 = w60 * w60;
    const double w62 = w55 + w61;
    const double w63 = w62 * w6;
    const double w64 = sqrt(w55);
    const double w65 = 1.0 / w64;
    const double w66 = w63 * w65;
    const double w67 = c[40][l] * w66;
    const double w68 = w67 + c[27][l];
    const double w69 = c[35][l] * w54;
    const double w70 = w68 + w69;
    const double w71 = c[43][l] * w62;
    const double w72 = w71 + c[44][l];
    const double w73 = c[42][l] * w54;
    const double w74 = w72 + w73;
    const double w75 = c[41][l] * w70;
    const double w76 = w75 + w74;
    const double w77 = c[45][l] * x2;
    const double w78 = x1 + w77;
    const double w79 = c[54][l] * x0;
    const double w80 = c[55][l] * x2;
    const double w81 = w79 + w80;
    const double w82 = c[52][l] * w78;
    const double w83 = w81 + w82;
    const double w84 = w83 * w83;
    const double w85 = c[57][l] * x0;
    const double w86 = c[58][l] * x2;
    const double w87 = w85 + w86;
    const double w88 = c[54][l] * w78;
    const double w89 = w87 + w88;
    const double w90 = w89 * w89;
    const double w91 = w84 + w90;
    const double w92 = w91 * w91;
    const double w93 = w92 + c[56][l];
    const double w94 = sqrt(w93);
    const double w95 = sqrt(w94);
    const double w96 = 1.0 / w95;
    const double w97 = w83 * w96;
    const double w98 = w84 + c[63][l];
    const double w99 = sqrt(w98);
    const double w100 = 1.0 / w99;
    const double w101 = w89 * w100;
    const double w102 = w90 + w98;
    const double w103 = sqrt(w102);
    const double w104 = 1.0 / w94;
    const double w105 = w90 * w104;
    const double w106 = w105 + 5e-13;
    const double w107 = 1.0 / w106;
    const double w108 = c[73][l] * x2;
    const double w109 = w79 + w108;
    const double w110 = c[57][l] * w78;
    const double w111 = w109 + w110;
    const double w112 = w111 * w111;
    const double w113 = c[52][l] * x0;
    const double w114 = c[74][l] * x2;
    const double w115 = w113 + w114;
    const double w116 = w115 + w88;
    const double w117 = w116 * w116;
    const double w118 = w112 + w117;
    const double w119 = w118 * w118;
    const double w120 = w119 + c[56][l];
    const double w121 = sqrt(w120);
    const double w122 = sqrt(w121);
    const double w123 = 1.0 / w122;
    const double w124 = w111 * w123;
    const double w125 = w112 + c[63][l];
    const double w126 = sqrt(w125);
    const double w127 = 1.0 / w126;
    const double w128 = w116 * w127;
    const double w129 = w117 + w125;
    const double w130 = sqrt(w129);
    const double w131 = 1.0 / w121;
    const double w132 = w117 * w131;
    const double w133 = w132 + 5e-13;
    const double w134 = 1.0 / w133;
    const double w135 = c[45][l] * w70;
    const double w136 = w135 + w74;
    const double w137 = c[41][l] * x2;
    const double w138 = x1 + w137;
    const double w139 = c[82][l] * x0;
    const double w140 = c[83][l] * w138;
    const double w141 = w139 + w140;
    const double w142 = w141 * w141;
    const double w143 = c[84][l] * x0;
    const double w144 = c[82][l] * w138;
    const double w145 = w143 + w144;
    const double w146 = w145 * w145;
    const double w147 = w142 + w146;
    const double w148 = w147 * w147;
    const double w149 = w148 + c[56][l];
    const double w150 = sqrt(w149);
    const double w151 = sqrt(w150);
    const double w152 = 1.0 / w151;
    const double w153 = w141 * w152;
    const double w154 = w142 + c[63][l];
    const double w155 = sqrt(w154);
    const double w156 = 1.0 / w155;
    const double w157 = w145 * w156;
    const double w158 = w146 + w154;
    const double w159 = sqrt(w158);
    const double w160 = c[103][l] * x2;
    const double w161 = x1 + w160;
    const double w162 = w161 + w59;
    const double w163 = lane_atan2(w162, w27);
    const double w164 = w163 + c[104][l];
    const double w165 = c[26][l] * w164;
    const double w166 = lane_min(c[101][l], w165);
    const double w167 = lane_max(c[102][l], w166);
    const double w168 = (-5.0) * w167;
    const double w169 = w168 + c[105][l];
    const double w170 = lane_max(0.0, w169);
    const double w171 = w170 * w170;
    const double w172 = w170 * w171;
    const double w173 = (-0.5) * w170;
    const double w174 = w173 + 1.0;
    const double w175 = w172 * w174;
    const double w176 = 5.0 * w167;
    const double w177 = w176 + c[105][l];
    const double w178 = lane_max(0.0, w177);
    const double w179 = w178 * w178;
    const double w180 = w178 * w179;
    const double w181 = (-0.5) * w178;
    const double w182 = w181 + 1.0;
    const double w183 = w180 * w182;
    const double w184 = w162 * w162;
    const double w185 = 0.2 * w175;
    const double w186 = w167 + w185;
    const double w187 = (-0.2) * w183;
    const double w188 = w186 + w187;
    const double w189 = w26 + w184;
    const double w190 = w188 * w189;
    const double w191 = sqrt(w62);
    const double w192 = w191 * x2;
    const double w193 = lane_atan2(w60, w64);
    const double w194 = c[23][l] * w193;
    const double w195 = w194 + c[110][l];
    const double w196 = w62 * w195;
    const double w197 = c[25][l] * w193;
    const double w198 = w197 + c[119][l];
    const double w199 = w62 * w198;
    const double w200 = x0 * w0;
    const double w201 = x1 * w1;
    const double w202 = -w201;
    const double w203 = w200 + w202;
    const double w204 = x0 * w1;
    const double w205 = x1 * w0;
    const double w206 = w204 + w205;
    const double w207 = c[132][l] * w76;
    const double w208 = lane_max(0.0, w207);
    const double w209 = lane_atan(w101);
    const double w210 = c[9][l] * w208;
    const double w211 = w210 + c[8][l];
    const double w212 = lane_max(0.001, w211);
    const double w213 = 1.0 / w212;
    const double w214 = c[49][l] * w212;
    const double w215 = w214 + c[50][l];
    const double w216 = w215 * w213;
    const double w217 = c[51][l] * w216;
    const double w218 = w217 + 5e-06;
    const double w219 = lane_min(w218, w97);
    const double w220 = -w218;
    const double w221 = lane_max(w220, w219);
    const double w222 = c[59][l] * w216;
    const double w223 = w222 + 0.5;
    const double w224 = (-100000.0) * w221;
    const double w225 = w223 + w224;
    const double w226 = lane_max(0.0, w225);
    const double w227 = w226 * w226;
    const double w228 = w226 * w227;
    const double w229 = (-0.5) * w226;
    const double w230 = w229 + 1.0;
    const double w231 = w228 * w230;
    const double w232 = 100000.0 * w221;
    const double w233 = w223 + w232;
    const double w234 = lane_max(0.0, w233);
    const double w235 = w234 * w234;
    const double w236 = w234 * w235;
    const double w237 = (-0.5) * w234;
    const double w238 = w237 + 1.0;
    const double w239 = w236 * w238;
    const double w240 = 1e-05 * w231;
    const double w241 = w221 + w240;
    const double w242 = (-1e-05) * w239;
    const double w243 = w241 + w242;
    const double w244 = w208 * w243;
    const double w245 = w244 * w212;
    const double w246 = c[10][l] * w245;
    const double w247 = w243 * w243;
    const double w248 = -w247;
    const double w249 = w248 + 1.0;
    const double w250 = sqrt(w249);
    const double w251 = w250 + 5e-06;
    const double w252 = c[7][l] * w208;
    const double w253 = w252 + c[6][l];
    const double w254 = lane_max(0.0, w253);
    const double w255 = w254 * w101;
    const double w256 = w255 * w213;
    const double w257 = c[51][l] * w256;
    const double w258 = lane_min(w257, c[61][l]);
    const double w259 = lane_max(c[62][l], w258);
    const double w260 = c[11][l] * w259;
    const double w261 = lane_atan(w260);
    const double w262 = c[64][l] * w259;
    const double w263 = c[65][l] * w261;
    const double w264 = w262 + w263;
    const double w265 = c[11][l] * w264;
    const double w266 = lane_atan(w265);
    const double w267 = c[12][l] * w266;
    const double w268 = lane_sin(w267);
    const double w269 = w268 * w103;
    const double w270 = w89 * w269;
    const double w271 = w270 * w104;
    const double w272 = c[13][l] * w271;
    const double w273 = w272 + 1e-12;
    const double w274 = w273 * w107;
    const double w275 = (-50.0) * w274;
    const double w276 = w275 + c[60][l];
    const double w277 = lane_min(1.0, w276);
    const double w278 = lane_max(0.0, w277);
    const double w279 = w278 * w278;
    const double w280 = w278 * w279;
    const double w281 = (-8.0) * w278;
    const double w282 = w281 + 6.0;
    const double w283 = 3.0 * w279;
    const double w284 = w282 + w283;
    const double w285 = w280 * w284;
    const double w286 = -w274;
    const double w287 = w286 + c[66][l];
    const double w288 = lane_max(0.0, w287);
    const double w289 = 0.02 * w285;
    const double w290 = w289 + w288;
    const double w291 = w89 * w290;
    const double w292 = w291 * w96;
    const double w293 = w269 * w96;
    const double w294 = c[13][l] * w293;
    const double w295 = w292 + w294;
    const double w296 = lane_min(w295, w251);
    const double w297 = -w251;
    const double w298 = lane_max(w297, w296);
    const double w299 = (-100000.0) * w250;
    const double w300 = w299 + 0.5;
    const double w301 = (-100000.0) * w298;
    const double w302 = w300 + w301;
    const double w303 = lane_max(0.0, w302);
    const double w304 = w303 * w303;
    const double w305 = w303 * w304;
    const double w306 = (-0.5) * w303;
    const double w307 = w306 + 1.0;
    const double w308 = w305 * w307;
    const double w309 = 100000.0 * w298;
    const double w310 = w300 + w309;
    const double w311 = lane_max(0.0, w310);
    const double w312 = w311 * w311;
    const double w313 = w311 * w312;
    const double w314 = (-0.5) * w311;
    const double w315 = w314 + 1.0;
    const double w316 = w313 * w315;
    const double w317 = 1e-05 * w308;
    const double w318 = w298 + w317;
    const double w319 = (-1e-05) * w316;
    const double w320 = w318 + w319;
    const double w321 = w208 * w320;
    const double w322 = w321 * w212;
    const double w323 = c[10][l] * w322;
    const double w324 = lane_atan(w128);
    const double w325 = c[70][l] * w212;
    const double w326 = w325 + c[71][l];
    const double w327 = w326 * w213;
    const double w328 = c[72][l] * w327;
    const double w329 = w328 + 5e-06;
    const double w330 = lane_min(w329, w124);
    const double w331 = -w329;
    const double w332 = lane_max(w331, w330);
    const double w333 = c[75][l] * w327;
    const double w334 = w333 + 0.5;
    const double w335 = (-100000.0) * w332;
    const double w336 = w334 + w335;
    const double w337 = lane_max(0.0, w336);
    const double w338 = w337 * w337;
    const double w339 = w337 * w338;
    const double w340 = (-0.5) * w337;
    const double w341 = w340 + 1.0;
    const double w342 = w339 * w341;
    const double w343 = 100000.0 * w332;
    const double w344 = w334 + w343;
    const double w345 = lane_max(0.0, w344);
    const double w346 = w345 * w345;
    const double w347 = w345 * w346;
    const double w348 = (-0.5) * w345;
    const double w349 = w348 + 1.0;
    const double w350 = w347 * w349;
    const double w351 = 1e-05 * w342;
    const double w352 = w332 + w351;
    const double w353 = (-1e-05) * w350;
    const double w354 = w352 + w353;
    const double w355 = w208 * w354;
    const double w356 = w355 * w212;
    const double w357 = c[14][l] * w356;
    const double w358 = w354 * w354;
    const double w359 = -w358;
    const double w360 = w359 + 1.0;
    const double w361 = sqrt(w360);
    const double w362 = w361 + 5e-06;
    const double w363 = w254 * w128;
    const double w364 = w363 * w213;
    const double w365 = c[72][l] * w364;
    const double w366 = lane_min(w365, c[61][l]);
    const double w367 = lane_max(c[62][l], w366);
    const double w368 = c[11][l] * w367;
    const double w369 = lane_atan(w368);
    const double w370 = c[64][l] * w367;
    const double w371 = c[65][l] * w369;
    const double w372 = w370 + w371;
    const double w373 = c[11][l] * w372;
    const double w374 = lane_atan(w373);
    const double w375 = c[12][l] * w374;
    const double w376 = lane_sin(w375);
    const double w377 = w376 * w130;
    const double w378 = w116 * w377;
    const double w379 = w378 * w131;
    const double w380 = c[13][l] * w379;
    const double w381 = w380 + 1e-12;
    const double w382 = w381 * w134;
    const double w383 = (-50.0) * w382;
    const double w384 = w383 + c[77][l];
    const double w385 = lane_min(1.0, w384);
    const double w386 = lane_max(0.0, w385);
    const double w387 = w386 * w386;
    const double w388 = w386 * w387;
    const double w389 = (-8.0) * w386;
    const double w390 = w389 + 6.0;
    const double w391 = 3.0 * w387;
    const double w392 = w390 + w391;
    const double w393 = w388 * w392;
    const double w394 = -w382;
    const double w395 = w394 + c[78][l];
    const double w396 = lane_max(0.0, w395);
    const double w397 = 0.02 * w393;
    const double w398 = w397 + w396;
    const double w399 = w116 * w398;
    const double w400 = w399 * w123;
    const double w401 = w377 * w123;
    const double w402 = c[13][l] * w401;
    const double w403 = w400 + w402;
    const double w404 = lane_min(w403, w362);
    const double w405 = -w362;
    const double w406 = lane_max(w405, w404);
    const double w407 = (-100000.0) * w361;
    const double w408 = w407 + 0.5;
    const double w409 = (-100000.0) * w406;
    const double w410 = w408 + w409;
    const double w411 = lane_max(0.0, w410);
    const double w412 = w411 * w411;
    const double w413 = w411 * w412;
    const double w414 = (-0.5) * w411;
    const double w415 = w414 + 1.0;
    const double w416 = w413 * w415;
    const double w417 = 100000.0 * w406;
    const double w418 = w408 + w417;
    const double w419 = lane_max(0.0, w418);
    const double w420 = w419 * w419;
    const double w421 = w419 * w420;
    const double w422 = (-0.5) * w419;
    const double w423 = w422 + 1.0;
    const double w424 = w421 * w423;
    const double w425 = 1e-05 * w416;
    const double w426 = w406 + w425;
    const double w427 = (-1e-05) * w424;
    const double w428 = w426 + w427;
    const double w429 = w208 * w428;
    const double w430 = w429 * w212;
    const double w431 = c[14][l] * w430;
    const double w432 = c[131][l] * w136;
    const double w433 = lane_max(0.0, w432);
    const double w434 = lane_atan(w157);
    const double w435 = c[18][l] * w433;
    const double w436 = w435 + c[17][l];
    const double w437 = lane_max(0.001, w436);
    const double w438 = 1.0 / w437;
    const double w439 = c[81][l] * w438;
    const double w440 = w439 + 5e-06;
    const double w441 = lane_min(w440, w153);
    const double w442 = -w440;
    const double w443 = lane_max(w442, w441);
    const double w444 = c[85][l] * w438;
    const double w445 = w444 + 0.5;
    const double w446 = (-100000.0) * w443;
    const double w447 = w445 + w446;
    const double w448 = lane_max(0.0, w447);
    const double w449 = w448 * w448;
    const double w450 = w448 * w449;
    const double w451 = (-0.5) * w448;
    const double w452 = w451 + 1.0;
    const double w453 = w450 * w452;
    const double w454 = 100000.0 * w443;
    const double w455 = w445 + w454;
    const double w456 = lane_max(0.0, w455);
    const double w457 = w456 * w456;
    const double w458 = w456 * w457;
    const double w459 = (-0.5) * w456;
    const double w460 = w459 + 1.0;
    const double w461 = w458 * w460;
    const double w462 = 1e-05 * w453;
    const double w463 = w443 + w462;
    const double w464 = (-1e-05) * w461;
    const double w465 = w463 + w464;
    const double w466 = w433 * w465;
    const double w467 = w466 * w437;
    const double w468 = c[19][l] * w467;
    const double w469 = w465 * w465;
    const double w470 = -w469;
    const double w471 = w470 + 1.0;
    const double w472 = sqrt(w471);
    const double w473 = w472 + 5e-06;
    const double w474 = c[16][l] * w433;
    const double w475 = w474 + c[15][l];
    const double w476 = lane_max(0.0, w475);
    const double w477 = w476 * w157;
    const double w478 = w477 * w438;
    const double w479 = c[80][l] * w478;
    const double w480 = lane_min(w479, c[86][l]);
    const double w481 = lane_max(c[87][l], w480);
    const double w482 = c[20][l] * w481;
    const double w483 = lane_atan(w482);
    const double w484 = c[89][l] * w481;
    const double w485 = c[88][l] * w483;
    const double w486 = w484 + w485;
    const double w487 = c[20][l] * w486;
    const double w488 = lane_atan(w487);
    const double w489 = c[21][l] * w488;
    const double w490 = lane_sin(w489);
    const double w491 = w490 * w159;
    const double w492 = w491 * w152;
    const double w493 = c[22][l] * w492;
    const double w494 = lane_min(w493, w473);
    const double w495 = -w473;
    const double w496 = lane_max(w495, w494);
    const double w497 = (-100000.0) * w472;
    const double w498 = w497 + 0.5;
    const double w499 = (-100000.0) * w496;
    const double w500 = w498 + w499;
    const double w501 = lane_max(0.0, w500);
    const double w502 = w501 * w501;
    const double w503 = w501 * w502;
    const double w504 = (-0.5) * w501;
    const double w505 = w504 + 1.0;
    const double w506 = w503 * w505;
    const double w507 = 100000.0 * w496;
    const double w508 = w498 + w507;
    const double w509 = lane_max(0.0, w508);
    const double w510 = w509 * w509;
    const double w511 = w509 * w510;
    const double w512 = (-0.5) * w509;
    const double w513 = w512 + 1.0;
    const double w514 = w511 * w513;
    const double w515 = 1e-05 * w506;
    const double w516 = w496 + w515;
    const double w517 = (-1e-05) * w514;
    const double w518 = w516 + w517;
    const double w519 = w433 * w518;
    const double w520 = w519 * w437;
    const double w521 = c[90][l] * w520;
    const double w522 = c[39][l] * w62;
    const double w523 = c[93][l] * w62;
    const double w524 = c[109][l] * w192;
    const double w525 = c[38][l] * w196;
    const double w526 = w524 + w525;
    const double w527 = c[24][l] * w193;
    const double w528 = w527 + c[134][l];
    const double w529 = w62 * w528;
    const double w530 = c[133][l] * w192;
    const double w531 = c[118][l] * w529;
    const double w532 = w530 + w531;
    const double w533 = c[135][l] * w192;
    const double w534 = c[118][l] * w199;
    const double w535 = w533 + w534;
    const double w536 = c[106][l] * w190;
    const double w537 = c[34][l] * w54;
    const double w538 = w206 * w206;
    const double w539 = w203 * w203;
    const double w540 = w538 + 1e-12;
    const double w541 = w540 + w539;
    const double w542 = sqrt(w541);
    const double w543 = c[69][l] * w245;
    const double w544 = c[67][l] * w322;
    const double w545 = w543 + w544;
    const double w546 = c[76][l] * w356;
    const double w547 = c[79][l] * w430;
    const double w548 = w546 + w547;
    const double w549 = c[92][l] * w467;
    const double w550 = c[91][l] * w520;
    const double w551 = w549 + w550;
    const double w552 = c[94][l] * w66;
    const double w553 = w552 + c[2][l];
    const double w554 = w553 + w545;
    const double w555 = -w548;
    const double w556 = w554 + w555;
    const double w557 = w556 + w551;
    const double w558 = c[67][l] * w245;
    const double w559 = c[68][l] * w322;
    const double w560 = w558 + w559;
    const double w561 = c[79][l] * w356;
    const double w562 = c[111][l] * w430;
    const double w563 = w561 + w562;
    const double w564 = c[112][l] * w467;
    const double w565 = c[113][l] * w520;
    const double w566 = w564 + w565;
    const double w567 = c[107][l] * w190;
    const double w568 = w567 + c[3][l];
    const double w569 = w568 + w526;
    const double w570 = -w560;
    const double w571 = w569 + w570;
    const double w572 = w571 + w563;
    const double w573 = -w566;
    const double w574 = w572 + w573;
    const double w575 = c[120][l] * w190;
    const double w576 = w575 + c[121][l];
    const double w577 = w576 + w535;
    const double w578 = c[53][l] * w545;
    const double w579 = w577 + w578;
    const double w580 = c[53][l] * w548;
    const double w581 = w579 + w580;
    const double w582 = c[122][l] * w560;
    const double w583 = w581 + w582;
    const double w584 = c[45][l] * w563;
    const double w585 = w583 + w584;
    const double w586 = c[46][l] * w566;
    const double w587 = w585 + w586;
    const double w588 = c[95][l] * w557;
    const double w589 = c[95][l] * w574;
    const double w590 = c[137][l] * w190;
    const double w591 = w590 + c[136][l];
    const double w592 = -w532;
    const double w593 = w591 + w592;
    const double w594 = c[138][l] * w560;
    const double w595 = w593 + w594;
    const double w596 = c[139][l] * w563;
    const double w597 = w595 + w596;
    const double w598 = c[140][l] * w566;
    const double w599 = w597 + w598;
    const double w600 = c[142][l] * w62;
    const double w601 = w600 + c[145][l];
    const double w602 = c[141][l] * w54;
    const double w603 = w601 + w602;
    const double w604 = c[143][l] * w545;
    const double w605 = w603 + w604;
    const double w606 = c[144][l] * w548;
    const double w607 = w605 + w606;
    const double w608 = c[140][l] * w551;
    const double w609 = w607 + w608;
    const double w610 = w542 + c[146][l];
    const double w611 = fabs(x4);
    const double w612 = w611 + c[147][l];
    const double w613 = fabs(x5);
    const double w614 = w613 + c[148][l];
    *y0 = w208;
    *y1 = w209;
    *y2 = w246;
    *y3 = w323;
    *y4 = w208;
    *y5 = w324;
    *y6 = w357;
    *y7 = w431;
    *y8 = w433;
    *y9 = w434;
    *y10 = w468;
    *y11 = w521;
    *y12 = c[4][l];
    *y13 = w193;
    *y14 = c[36][l];
    *y15 = w522;
    *y16 = w523;
    *y17 = w526;
    *y18 = w532;
    *y19 = w71;
    *y20 = w535;
    *y21 = w163;
    *y22 = w188;
    *y23 = w536;
    *y24 = w30;
    *y25 = w53;
    *y26 = w537;
    *y27 = w542;
    *y28 = w557;
    *y29 = w574;
    *y30 = w587;
    *y31 = w588;
    *y32 = w589;
    *y33 = w70;
    *y34 = w599;
    *y35 = w609;
    *y36 = w610;
    *y37 = w612;
    *y38 = w614;
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
