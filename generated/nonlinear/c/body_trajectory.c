/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* What every kernel of a model begins with; a driver follows. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 16 };
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


enum { NS = 5, ND = 2, NP = 20, NC = 43, NW = 10, NY = 11, NY1 = 11 };
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
    f[4][l] = x1;
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

static void rates(const lanes *c, lanes *w, const lanes *x, lanes *f)
{
    LANE_LOOP {
        rate0(c, w, f, f, l, x[0][l], x[1][l]);
    }
    LANE_LOOP rate1(c, w, f, f, l);
    LANE_LOOP rate2(c, w, f, f, l);
}

INLINE void output(const lanes *c, int l, double x0, double x1, double x2, double x3, double x6, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10)
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

static void observe_row(const lanes *c, int l, double (*x)[TILE], double (*y)[TILE], int count)
{
    _Pragma("omp simd")
    for (int s = 0; s < count; ++s)
        output(c, l, x[0][s], x[1][s], x[2][s], x[3][s], x[4][s], &y[0][s], &y[1][s], &y[2][s], &y[3][s], &y[4][s], &y[5][s], &y[6][s], &y[7][s], &y[8][s], &y[9][s], &y[10][s]);
}


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
static const double AT_NODES = 0.01;       /* what of the cut is felt at the end of a step */
static const double PACE = 0.3;            /* wanted ratio of a sweep's change to the last one's */
static const double SLOW = 0.8;            /* ratio at which a step is given up */
static const double SHRINK = 0.3, GROW = 3.0;  /* step / step before */

typedef struct {
    lanes c[NC], w[NW], x[NS], f[NS];      /* constants; states and rates at the nodes */
    double wave[NS][LANES];                /* Chebyshev coefficients of the rates over the step */
    double path[NS][LANES + 1];            /* and of the states */
    double begin[NS], end[NS], scale[NS], past[NS];
    double t, h, from, span;               /* begin, length; where `wave` is left, its length */
    double ratio, left, cut, drift, estimate;
    int64_t next;
} __attribute__((aligned(64))) step_t;

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
    for (int count = 1; count <= MOST_SWEEPS; ++count) {
        const double now = sweep(s);
        rates(s->c, s->w, s->x, s->f);
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

/* Follow the global error along the motion: a local error made at s has grown by about
 * |f(t)| / |f(s)| at t, and has moved a quadrature by f(t) - f(s) in the same proportion.  Steps
 * are good to far less than tol, so that nothing has to be followed across it. */
static void follow_error(step_t *s, double rest)
{
    double first[NS], last[NS], head = rest, tail = 0.0;
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

/* ---- the trajectory ------------------------------------------------------------------------ */

/* Start with constant rates; an explicit Euler probe measures how fast they change. */
static void start(step_t *s, const job_t *job)
{
    const double probe = 1e-4 * job->t_end;
    lanes now[NS];
    double change = 0.0;
    memset(s->wave, 0, sizeof s->wave);
    for (int j = 0; j < NS; ++j) {
        s->begin[j] = *job->x0[j];
        s->scale[j] = larger(fabs(s->begin[j]), SCALE_FLOOR);
        s->past[j] = 0.0;
        LANE_LOOP s->x[j][l] = s->begin[j];
    }
    rates(s->c, s->w, s->x, now);
    for (int j = 0; j < NS; ++j) {
        s->wave[j][0] = now[j][0];
        LANE_LOOP s->x[j][l] += probe * now[j][l];
    }
    rates(s->c, s->w, s->x, s->f);
    for (int j = 0; j < ND; ++j)
        change = larger(change, fabs(s->f[j][0] - now[j][0]) / (fabs(now[j][0]) + SCALE_FLOOR));
    s->h = larger(smaller(probe / (change + DBL_MIN), job->t_end), 1e-6 * job->t_end);
    s->t = s->drift = s->estimate = 0.0;
    s->from = -1.0;
    s->span = s->h;
    s->next = 0;
}

/* States and outputs at the sample times within the step. */
static void sample(step_t *s, const job_t *job, double end)
{
    double at[NS][TILE], y[NY1][TILE], z[TILE];
    while (s->next < job->n_times && job->times[s->next] <= end) {
        int count = 0;
        for (; count < TILE && s->next + count < job->n_times; ++count) {
            if (job->times[s->next + count] > end)
                break;
            z[count] = 2.0 * (job->times[s->next + count] - s->t) / s->h - 1.0;
        }
        for (int j = 0; j < NS; ++j) {
            const double *path = s->path[j];
#pragma omp simd
            for (int i = 0; i < count; ++i) {
                double before = 0.0, now = 0.0;
                for (int k = LANES; k > 0; --k) {
                    const double next = path[k] + 2.0 * z[i] * now - before;
                    before = now;
                    now = next;
                }
                at[j][i] = path[0] + z[i] * now - before;
            }
        }
        if (job->observed)
            observe_row(s->c, 0, at, y, count);
        for (int j = 0; j < ROWS; ++j)
            if (job->samples[j])
                memcpy(job->samples[j] + s->next, j < NS ? at[j] : y[j - NS],
                       (size_t)count * sizeof(double));
        s->next += count;
    }
}

/* Go to the end with sweeps and polynomials good to tau; the status. */
static int travel(step_t *s, const job_t *job, double tau, int64_t *steps)
{
    start(s, job);
    while (s->t < job->t_end) {
        const double rest = job->t_end - s->t;
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
        follow_error(s, REST / job->t_end);
        const double end = s->h >= rest ? job->t_end : s->t + s->h;
        sample(s, job, end);
        memcpy(s->begin, s->end, sizeof s->begin);
        s->t = end;
        s->from = 1.0;
        s->h *= larger(smaller(smaller(room, PACE / (s->ratio + DBL_MIN)), GROW), SHRINK);
    }
    return OK;
}

/* Integrate the one trajectory of the job. */
__attribute__((visibility("default"))) void trace(const job_t *job)
{
    step_t s;
    lanes p[NP];
    int64_t steps = 0;
    int status = UNSURE;
    for (int j = 0; j < NP; ++j)
        LANE_LOOP p[j][l] = *job->p[j];
    constants(p, s.c);
    double tau = smaller(MARGIN * job->tol, COARSEST);
    for (int attempt = 0; attempt <= RETRIES; ++attempt) {
        status = travel(&s, job, tau, &steps);
        if (status != OK || s.estimate <= job->tol)
            break;
        status = UNSURE;
        tau = larger(0.3 * tau * job->tol / s.estimate, FINEST);
    }
    for (int j = 0; j < ROWS; ++j)
        for (int64_t i = s.next; job->samples[j] && i < job->n_times; ++i)
            job->samples[j][i] = NAN;
    *job->status = (int8_t)status;
    *job->steps = (int32_t)steps;
    *job->estimate = s.estimate;
}

