/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* Functions of named scalars at many points; p[k] is a column, or one number if its stride is 0,
 * and y[k] a column, or NULL if it is not wanted. */
#include <math.h>
#include <stdint.h>

#define SHOWN __attribute__((visibility("default")))
enum { POINTS = 512, MOST = 40 };   /* points in a block; arguments or results of a function */

typedef void block_function(int64_t n, const double **p, double **y);

/* fmax and fmin of C, which a loop can be vectorised with: a NaN gives way to a number. */
static inline double larger(double a, double b) { return a > b || b != b ? a : b; }
static inline double smaller(double a, double b) { return a < b || b != b ? a : b; }

/* One block of points, every argument a column of it. */
static void sweep_block(block_function *f, int n_in, int n_out, int64_t from, int64_t end,
    double (*same)[POINTS], const double *const *p, const int64_t *stride, double *const *y)
{
    const double *columns[MOST];
    double *results[MOST], unwanted[POINTS] __attribute__((aligned(64)));
    for (int k = 0; k < n_in; ++k)
        columns[k] = stride[k] ? p[k] + from : same[k];
    for (int k = 0; k < n_out; ++k)
        results[k] = y[k] ? y[k] + from : unwanted;
    f(end - from < POINTS ? end - from : POINTS, columns, results);
}

static void sweep(block_function *f, int n_in, int n_out, int64_t n, int64_t threads,
    const double *const *p, const int64_t *stride, double *const *y)
{
    double same[MOST][POINTS] __attribute__((aligned(64)));
    for (int k = 0; k < n_in; ++k)
        for (int i = 0; i < POINTS && !stride[k]; ++i)
            same[k][i] = *p[k];
    /* a short block first, so that the others begin where a line of the cache does */
    const int64_t odd = (8 - (int64_t)((uintptr_t)y[0] / sizeof(double) % 8)) % 8;
    const int64_t head = odd < n ? odd : n;
    sweep_block(f, n_in, n_out, 0, head, same, p, stride, y);
    if (threads <= 1) {
        for (int64_t from = head; from < n; from += POINTS)
            sweep_block(f, n_in, n_out, from, n, same, p, stride, y);
        return;
    }
#pragma omp parallel for schedule(static) num_threads((int)threads)
    for (int64_t from = head; from < n; from += POINTS)
        sweep_block(f, n_in, n_out, from, n, same, p, stride, y);
}

static void state_matrix_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, double *y0, double *y1, double *y2, double *y3)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p8[i];
        const double w1 = 2.0 * w0;
        const double w2 = p9[i];
        const double w3 = 0.5;
        const double w4 = p6[i];
        const double w5 = w3 * w4;
        const double w6 = p7[i];
        const double w7 = w5 * w6;
        const double w8 = p5[i];
        const double w9 = w7 * w8;
        const double w10 = p4[i];
        const double w11 = w10 * w10;
        const double w12 = w9 * w11;
        const double w13 = w2 + w12;
        const double w14 = w1 + w13;
        const double w15 = p0[i];
        const double w16 = w15 * w10;
        const double w17 = w14 / w16;
        const double w18 = -w17;
        y0[i] = w18;
        const double w20 = w10 * w10;
        const double w21 = w15 * w20;
        const double w22 = p2[i];
        const double w23 = w1 * w22;
        const double w24 = p3[i];
        const double w25 = w13 * w24;
        const double w26 = w23 - w25;
        const double w27 = w21 + w26;
        const double w28 = w27 / w16;
        const double w29 = -w28;
        y1[i] = w29;
        const double w31 = p1[i];
        const double w32 = w31 * w10;
        const double w33 = w26 / w32;
        const double w34 = -w33;
        y2[i] = w34;
        const double w36 = w22 * w22;
        const double w37 = w1 * w36;
        const double w38 = w24 * w24;
        const double w39 = w13 * w38;
        const double w40 = w37 + w39;
        const double w41 = w40 / w32;
        const double w42 = -w41;
        y3[i] = w42;
    }
}

static void state_matrix_any(int64_t n, const double **p, double **y)
{
    state_matrix_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], y[0], y[1], y[2], y[3]);
}

SHOWN void sweep_state_matrix(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(state_matrix_any, 10, 4, n, threads, p, stride, y);
}

static void routh_hurwitz_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, double *y0, double *y1, double *y2)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p8[i];
        const double w1 = 2.0 * w0;
        const double w2 = p2[i];
        const double w3 = w2 * w2;
        const double w4 = p1[i];
        const double w5 = p4[i];
        const double w6 = w4 * w5;
        const double w7 = w3 / w6;
        const double w8 = p0[i];
        const double w9 = w8 * w5;
        const double w10 = 1.0 / w9;
        const double w11 = w7 + w10;
        const double w12 = w1 * w11;
        const double w13 = p9[i];
        const double w14 = 0.5;
        const double w15 = p6[i];
        const double w16 = w14 * w15;
        const double w17 = p7[i];
        const double w18 = w16 * w17;
        const double w19 = p5[i];
        const double w20 = w18 * w19;
        const double w21 = w5 * w5;
        const double w22 = w20 * w21;
        const double w23 = w13 + w22;
        const double w24 = p3[i];
        const double w25 = w24 * w24;
        const double w26 = w25 / w6;
        const double w27 = w26 + w10;
        const double w28 = w23 * w27;
        const double w29 = w12 + w28;
        const double w30 = -w29;
        y0[i] = w30;
        const double w32 = w1 * w23;
        const double w33 = w2 + w24;
        const double w34 = w33 * w33;
        const double w35 = w32 * w34;
        const double w36 = w4 * w8;
        const double w37 = w5 * w5;
        const double w38 = w36 * w37;
        const double w39 = w35 / w38;
        const double w40 = w1 * w2;
        const double w41 = w40 / w4;
        const double w42 = w39 - w41;
        const double w43 = w23 * w24;
        const double w44 = w43 / w4;
        const double w45 = w42 + w44;
        y1[i] = w45;
        const double w47 = -4.0;
        const double w48 = w47 * w45;
        const double w49 = w29 * w29;
        const double w50 = w48 + w49;
        y2[i] = w50;
    }
}

static void routh_hurwitz_any(int64_t n, const double **p, double **y)
{
    routh_hurwitz_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], y[0], y[1], y[2]);
}

SHOWN void sweep_routh_hurwitz(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(routh_hurwitz_any, 10, 3, n, threads, p, stride, y);
}

static void modes_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = 0.0;
        const double w1 = 4.0;
        const double w2 = p2[i];
        const double w3 = w1 * w2;
        const double w4 = p1[i];
        const double w5 = w3 * w4;
        const double w6 = p0[i];
        const double w7 = p3[i];
        const double w8 = w6 - w7;
        const double w9 = w8 * w8;
        const double w10 = w5 + w9;
        const double w11 = w0 < w10 ? 1.0 : 0.0;
        const double w12 = 0.5;
        const double w13 = fabs(w10);
        const double w14 = sqrt(w13);
        const double w15 = w12 * w14;
        const double w16 = w7 + w6;
        const double w17 = w15 * w16;
        const double w18 = w11 != 0.0 ? w17 : 0.0;
        const double w19 = -0.25;
        const double w20 = w16 * w16;
        const double w21 = w19 * w20;
        const double w22 = w18 < w21 ? 1.0 : 0.0;
        const double w23 = w7 * w6;
        const double w24 = w2 * w4;
        const double w25 = w23 - w24;
        const double w26 = fabs(w25);
        const double w27 = 3.552713678800501e-15;
        const double w28 = w7 * w6;
        const double w29 = fabs(w28);
        const double w30 = w27 * w29;
        const double w31 = w2 * w4;
        const double w32 = fabs(w31);
        const double w33 = w27 * w32;
        const double w34 = w30 + w33;
        const double w35 = w26 < w34 ? 1.0 : 0.0;
        const double w36 = w35 == 0.0 ? 1.0 : 0.0;
        const double w37 = w36 != 0.0 ? w25 : 0.0;
        const double w38 = w12 * w16;
        const double w39 = w11 != 0.0 ? w15 : 0.0;
        const double w40 = w38 - w39;
        const double w41 = w37 / w40;
        const double w42 = w22 != 0.0 ? w41 : 0.0;
        const double w43 = w22 == 0.0 ? 1.0 : 0.0;
        const double w44 = w12 * w16;
        const double w45 = w39 + w44;
        const double w46 = w43 != 0.0 ? w45 : 0.0;
        const double w47 = w42 + w46;
        y0[i] = w47;
        const double w49 = w10 < w0 ? 1.0 : 0.0;
        const double w50 = w49 != 0.0 ? w15 : 0.0;
        y1[i] = w50;
        y2[i] = w40;
        const double w53 = -w50;
        y3[i] = w53;
        const double w55 = fabs(w47);
        const double w56 = w55 <= w0 ? 1.0 : 0.0;
        const double w57 = w56 == 0.0 ? 1.0 : 0.0;
        const double w58 = -w47;
        const double w59 = w57 != 0.0 ? w58 : 0.0;
        y4[i] = w59;
        const double w61 = sqrt(w37);
        y5[i] = w61;
        y6[i] = w50;
        const double w64 = -0.5;
        const double w65 = w64 * w16;
        const double w66 = w65 / w61;
        y7[i] = w66;
    }
}

static void modes_any(int64_t n, const double **p, double **y)
{
    modes_block(n, p[0], p[1], p[2], p[3], y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]);
}

SHOWN void sweep_modes(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(modes_any, 4, 8, n, threads, p, stride, y);
}

static void linear_modes_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = 0.0;
        const double w1 = 4.0;
        const double w2 = p8[i];
        const double w3 = 2.0 * w2;
        const double w4 = p2[i];
        const double w5 = w3 * w4;
        const double w6 = p9[i];
        const double w7 = 0.5;
        const double w8 = p6[i];
        const double w9 = w7 * w8;
        const double w10 = p7[i];
        const double w11 = w9 * w10;
        const double w12 = p5[i];
        const double w13 = w11 * w12;
        const double w14 = p4[i];
        const double w15 = w14 * w14;
        const double w16 = w13 * w15;
        const double w17 = w6 + w16;
        const double w18 = p3[i];
        const double w19 = w17 * w18;
        const double w20 = w5 - w19;
        const double w21 = p1[i];
        const double w22 = w21 * w14;
        const double w23 = w20 / w22;
        const double w24 = w1 * w23;
        const double w25 = p0[i];
        const double w26 = w14 * w14;
        const double w27 = w25 * w26;
        const double w28 = w27 + w20;
        const double w29 = w25 * w14;
        const double w30 = w28 / w29;
        const double w31 = w24 * w30;
        const double w32 = w4 * w4;
        const double w33 = w3 * w32;
        const double w34 = w18 * w18;
        const double w35 = w17 * w34;
        const double w36 = w33 + w35;
        const double w37 = w36 / w22;
        const double w38 = w3 + w17;
        const double w39 = w38 / w29;
        const double w40 = w37 - w39;
        const double w41 = w40 * w40;
        const double w42 = w31 + w41;
        const double w43 = w0 < w42 ? 1.0 : 0.0;
        const double w44 = fabs(w42);
        const double w45 = sqrt(w44);
        const double w46 = w7 * w45;
        const double w47 = w37 + w39;
        const double w48 = w46 * w47;
        const double w49 = -w48;
        const double w50 = w43 != 0.0 ? w49 : 0.0;
        const double w51 = -0.25;
        const double w52 = w47 * w47;
        const double w53 = w51 * w52;
        const double w54 = w50 < w53 ? 1.0 : 0.0;
        const double w55 = w37 * w39;
        const double w56 = w23 * w30;
        const double w57 = w55 - w56;
        const double w58 = fabs(w57);
        const double w59 = 3.552713678800501e-15;
        const double w60 = w37 * w39;
        const double w61 = fabs(w60);
        const double w62 = w59 * w61;
        const double w63 = w23 * w30;
        const double w64 = fabs(w63);
        const double w65 = w59 * w64;
        const double w66 = w62 + w65;
        const double w67 = w58 < w66 ? 1.0 : 0.0;
        const double w68 = w67 == 0.0 ? 1.0 : 0.0;
        const double w69 = w68 != 0.0 ? w57 : 0.0;
        const double w70 = w43 != 0.0 ? w46 : 0.0;
        const double w71 = w7 * w47;
        const double w72 = w70 + w71;
        const double w73 = w69 / w72;
        const double w74 = -w73;
        const double w75 = w54 != 0.0 ? w74 : 0.0;
        const double w76 = w54 == 0.0 ? 1.0 : 0.0;
        const double w77 = w7 * w47;
        const double w78 = w70 - w77;
        const double w79 = w76 != 0.0 ? w78 : 0.0;
        const double w80 = w75 + w79;
        y0[i] = w80;
        const double w82 = w42 < w0 ? 1.0 : 0.0;
        const double w83 = w82 != 0.0 ? w46 : 0.0;
        y1[i] = w83;
        const double w85 = -w72;
        y2[i] = w85;
        const double w87 = -w83;
        y3[i] = w87;
        const double w89 = fabs(w80);
        const double w90 = w89 <= w0 ? 1.0 : 0.0;
        const double w91 = w90 == 0.0 ? 1.0 : 0.0;
        const double w92 = -w80;
        const double w93 = w91 != 0.0 ? w92 : 0.0;
        y4[i] = w93;
        const double w95 = sqrt(w69);
        y5[i] = w95;
        y6[i] = w83;
        const double w98 = -0.5;
        const double w99 = w98 * w47;
        const double w100 = w99 / w95;
        const double w101 = -w100;
        y7[i] = w101;
    }
}

static void linear_modes_any(int64_t n, const double **p, double **y)
{
    linear_modes_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]);
}

SHOWN void sweep_linear_modes(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(linear_modes_any, 10, 8, n, threads, p, stride, y);
}

static void times_block(int64_t n, const double *restrict p0, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = 1.3862943611198906;
        const double w1 = p0[i];
        const double w2 = fabs(w1);
        const double w3 = w1 + w2;
        const double w4 = w0 / w3;
        y0[i] = w4;
        const double w6 = fabs(w1);
        const double w7 = w6 - w1;
        const double w8 = w0 / w7;
        y1[i] = w8;
    }
}

static void times_any(int64_t n, const double **p, double **y)
{
    times_block(n, p[0], y[0], y[1]);
}

SHOWN void sweep_times(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(times_any, 1, 2, n, threads, p, stride, y);
}

static void speed_window_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = 1.4142135623730951;
        const double w1 = p6[i];
        const double w2 = 2.0 * w1;
        const double w3 = p7[i];
        const double w4 = w2 * w3;
        const double w5 = p1[i];
        const double w6 = p2[i];
        const double w7 = w5 + w6;
        const double w8 = w7 * w7;
        const double w9 = w4 * w8;
        const double w10 = -4.0;
        const double w11 = w10 * w9;
        const double w12 = 0.5;
        const double w13 = p4[i];
        const double w14 = w12 * w13;
        const double w15 = p5[i];
        const double w16 = w14 * w15;
        const double w17 = p3[i];
        const double w18 = w16 * w17;
        const double w19 = w6 * w18;
        const double w20 = p0[i];
        const double w21 = w19 * w20;
        const double w22 = w11 * w21;
        const double w23 = w5 * w5;
        const double w24 = w2 * w23;
        const double w25 = w24 * w18;
        const double w26 = 4.0;
        const double w27 = w26 * w1;
        const double w28 = w27 * w5;
        const double w29 = w28 * w6;
        const double w30 = w29 * w18;
        const double w31 = w25 + w30;
        const double w32 = w2 * w5;
        const double w33 = w32 * w20;
        const double w34 = w31 - w33;
        const double w35 = w6 * w6;
        const double w36 = w2 * w35;
        const double w37 = w36 * w18;
        const double w38 = w34 + w37;
        const double w39 = w3 * w6;
        const double w40 = w39 * w20;
        const double w41 = w38 + w40;
        const double w42 = w41 * w41;
        const double w43 = w22 + w42;
        const double w44 = sqrt(w43);
        const double w45 = w44 - w41;
        const double w46 = w9 * w45;
        const double w47 = sqrt(w46);
        const double w48 = w0 * w47;
        const double w49 = w48 / w45;
        y0[i] = w49;
        const double w51 = 0.7071067811865476;
        const double w52 = w51 * w45;
        const double w53 = w21 * w45;
        const double w54 = sqrt(w53);
        const double w55 = w52 / w54;
        y1[i] = w55;
    }
}

static void speed_window_any(int64_t n, const double **p, double **y)
{
    speed_window_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], y[0], y[1]);
}

SHOWN void sweep_speed_window(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(speed_window_any, 8, 2, n, threads, p, stride, y);
}

static void weakest_speed_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p7[i];
        const double w1 = 2.0 * w0;
        const double w2 = p8[i];
        const double w3 = w1 * w2;
        const double w4 = p2[i];
        const double w5 = p3[i];
        const double w6 = w4 + w5;
        const double w7 = w6 * w6;
        const double w8 = w3 * w7;
        const double w9 = 0.5;
        const double w10 = p5[i];
        const double w11 = w9 * w10;
        const double w12 = p6[i];
        const double w13 = w11 * w12;
        const double w14 = p4[i];
        const double w15 = w13 * w14;
        const double w16 = w5 * w15;
        const double w17 = p0[i];
        const double w18 = w16 * w17;
        const double w19 = w8 / w18;
        const double w20 = sqrt(w19);
        const double w21 = sqrt(w20);
        y0[i] = w21;
        const double w23 = w4 * w4;
        const double w24 = w1 * w23;
        const double w25 = w24 * w15;
        const double w26 = 4.0;
        const double w27 = w26 * w0;
        const double w28 = w27 * w4;
        const double w29 = w28 * w5;
        const double w30 = w29 * w15;
        const double w31 = w25 + w30;
        const double w32 = w1 * w4;
        const double w33 = w32 * w17;
        const double w34 = w31 - w33;
        const double w35 = w5 * w5;
        const double w36 = w1 * w35;
        const double w37 = w36 * w15;
        const double w38 = w34 + w37;
        const double w39 = w2 * w5;
        const double w40 = w39 * w17;
        const double w41 = w38 + w40;
        const double w42 = w8 * w18;
        const double w43 = sqrt(w42);
        const double w44 = 2.0 * w43;
        const double w45 = w41 + w44;
        const double w46 = p1[i];
        const double w47 = w46 * w17;
        const double w48 = w45 / w47;
        y1[i] = w48;
    }
}

static void weakest_speed_any(int64_t n, const double **p, double **y)
{
    weakest_speed_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], y[0], y[1]);
}

SHOWN void sweep_weakest_speed(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(weakest_speed_any, 9, 2, n, threads, p, stride, y);
}

static void stationary_decay_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p7[i];
        const double w1 = 2.0 * w0;
        const double w2 = p8[i];
        const double w3 = w1 * w2;
        const double w4 = p2[i];
        const double w5 = p3[i];
        const double w6 = w4 + w5;
        const double w7 = w6 * w6;
        const double w8 = w3 * w7;
        const double w9 = -4.0;
        const double w10 = w9 * w8;
        const double w11 = p1[i];
        const double w12 = p0[i];
        const double w13 = w11 * w12;
        const double w14 = 1.0 / w12;
        const double w15 = w4 * w4;
        const double w16 = w15 / w11;
        const double w17 = w14 + w16;
        const double w18 = w1 * w17;
        const double w19 = 1.0 / w12;
        const double w20 = w5 * w5;
        const double w21 = w20 / w11;
        const double w22 = w19 + w21;
        const double w23 = w2 * w22;
        const double w24 = w18 + w23;
        const double w25 = w24 * w24;
        const double w26 = w13 * w25;
        const double w27 = w10 + w26;
        const double w28 = w8 * w27;
        const double w29 = -w28;
        y0[i] = w29;
        const double w31 = w11 * w12;
        const double w32 = w31 * w24;
        const double w33 = 2.0 * w8;
        const double w34 = 0.5;
        const double w35 = p5[i];
        const double w36 = w34 * w35;
        const double w37 = p6[i];
        const double w38 = w36 * w37;
        const double w39 = p4[i];
        const double w40 = w38 * w39;
        const double w41 = w40 * w22;
        const double w42 = w33 * w41;
        const double w43 = w4 * w4;
        const double w44 = w1 * w43;
        const double w45 = w44 * w40;
        const double w46 = 4.0;
        const double w47 = w46 * w0;
        const double w48 = w47 * w4;
        const double w49 = w48 * w5;
        const double w50 = w49 * w40;
        const double w51 = w45 + w50;
        const double w52 = w1 * w4;
        const double w53 = w52 * w12;
        const double w54 = w51 - w53;
        const double w55 = w5 * w5;
        const double w56 = w1 * w55;
        const double w57 = w56 * w40;
        const double w58 = w54 + w57;
        const double w59 = w2 * w5;
        const double w60 = w59 * w12;
        const double w61 = w58 + w60;
        const double w62 = w61 * w24;
        const double w63 = w42 - w62;
        const double w64 = w32 * w63;
        const double w65 = -w64;
        y1[i] = w65;
        const double w67 = -2.0;
        const double w68 = w67 * w11;
        const double w69 = w68 * w12;
        const double w70 = w69 * w61;
        const double w71 = w70 * w41;
        const double w72 = w71 * w24;
        const double w73 = 8.0;
        const double w74 = w73 * w8;
        const double w75 = w5 * w40;
        const double w76 = w75 * w12;
        const double w77 = w74 * w76;
        const double w78 = w72 - w77;
        const double w79 = 3.0;
        const double w80 = w79 * w8;
        const double w81 = w11 * w12;
        const double w82 = w41 * w41;
        const double w83 = w81 * w82;
        const double w84 = w80 * w83;
        const double w85 = w78 + w84;
        const double w86 = w79 * w76;
        const double w87 = w86 * w26;
        const double w88 = w85 + w87;
        y2[i] = w88;
        const double w90 = w11 * w12;
        const double w91 = w90 * w41;
        const double w92 = w61 * w41;
        const double w93 = 2.0 * w76;
        const double w94 = w93 * w24;
        const double w95 = w92 - w94;
        const double w96 = w91 * w95;
        y3[i] = w96;
        const double w98 = w9 * w76;
        const double w99 = w98 + w83;
        const double w100 = w76 * w99;
        const double w101 = -w100;
        y4[i] = w101;
        const double w103 = w24 / w41;
        const double w104 = sqrt(w103);
        y5[i] = w104;
    }
}

static void stationary_decay_any(int64_t n, const double **p, double **y)
{
    stationary_decay_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], y[0], y[1], y[2], y[3], y[4], y[5]);
}

SHOWN void sweep_stationary_decay(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(stationary_decay_any, 9, 6, n, threads, p, stride, y);
}

static void steady_margins_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, double *y0, double *y1, double *y2)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p7[i];
        const double w1 = 2.0 * w0;
        const double w2 = p1[i];
        const double w3 = w1 * w2;
        const double w4 = p8[i];
        const double w5 = 0.5;
        const double w6 = p5[i];
        const double w7 = w5 * w6;
        const double w8 = p6[i];
        const double w9 = w7 * w8;
        const double w10 = p4[i];
        const double w11 = w9 * w10;
        const double w12 = p3[i];
        const double w13 = w12 * w12;
        const double w14 = w11 * w13;
        const double w15 = w4 + w14;
        const double w16 = p2[i];
        const double w17 = w15 * w16;
        const double w18 = w3 - w17;
        const double w19 = w1 + w15;
        const double w20 = w18 / w19;
        y0[i] = w20;
        const double w22 = w2 + w16;
        const double w23 = w20 / w22;
        const double w24 = -w23;
        y1[i] = w24;
        const double w26 = p0[i];
        const double w27 = w26 * w18;
        const double w28 = w1 * w15;
        const double w29 = w28 * w22;
        const double w30 = w27 / w29;
        const double w31 = -w30;
        y2[i] = w31;
    }
}

static void steady_margins_any(int64_t n, const double **p, double **y)
{
    steady_margins_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], y[0], y[1], y[2]);
}

SHOWN void sweep_steady_margins(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(steady_margins_any, 9, 3, n, threads, p, stride, y);
}

static void tail_wheel_needed_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, double *y0)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p7[i];
        const double w1 = 2.0 * w0;
        const double w2 = p1[i];
        const double w3 = w1 * w2;
        const double w4 = p0[i];
        const double w5 = p3[i];
        const double w6 = w5 * w5;
        const double w7 = w4 * w6;
        const double w8 = w3 * w7;
        const double w9 = w2 * w2;
        const double w10 = w1 * w9;
        const double w11 = 4.0;
        const double w12 = w11 * w0;
        const double w13 = w12 * w2;
        const double w14 = p2[i];
        const double w15 = w13 * w14;
        const double w16 = w10 + w15;
        const double w17 = w14 * w14;
        const double w18 = w1 * w17;
        const double w19 = w16 + w18;
        const double w20 = w14 * w7;
        const double w21 = w19 + w20;
        const double w22 = w8 / w21;
        const double w23 = 0.5;
        const double w24 = p5[i];
        const double w25 = w23 * w24;
        const double w26 = p6[i];
        const double w27 = w25 * w26;
        const double w28 = p4[i];
        const double w29 = w27 * w28;
        const double w30 = w5 * w5;
        const double w31 = w29 * w30;
        const double w32 = w22 - w31;
        y0[i] = w32;
    }
}

static void tail_wheel_needed_any(int64_t n, const double **p, double **y)
{
    tail_wheel_needed_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], y[0]);
}

SHOWN void sweep_tail_wheel_needed(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(tail_wheel_needed_any, 8, 1, n, threads, p, stride, y);
}

static void tail_wheel_always_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = 0.0;
        const double w1 = p6[i];
        const double w2 = 2.0 * w1;
        const double w3 = sqrt(w2);
        const double w4 = p0[i];
        const double w5 = sqrt(w4);
        const double w6 = p1[i];
        const double w7 = larger(w0, w6);
        const double w8 = sqrt(w7);
        const double w9 = w5 * w8;
        const double w10 = p2[i];
        const double w11 = w6 + w10;
        const double w12 = 0.5;
        const double w13 = p4[i];
        const double w14 = w12 * w13;
        const double w15 = p5[i];
        const double w16 = w14 * w15;
        const double w17 = p3[i];
        const double w18 = w16 * w17;
        const double w19 = sqrt(w18);
        const double w20 = w11 * w19;
        const double w21 = w9 - w20;
        const double w22 = w3 * w21;
        const double w23 = sqrt(w10);
        const double w24 = w23 * w5;
        const double w25 = w22 / w24;
        const double w26 = larger(w0, w25);
        const double w27 = w26 * w26;
        y0[i] = w27;
        const double w29 = p7[i];
        const double w30 = sqrt(w29);
        const double w31 = w30 - w25;
        const double w32 = w23 * w31;
        const double w33 = sqrt(w11);
        const double w34 = w33 * w3;
        const double w35 = w32 / w34;
        y1[i] = w35;
    }
}

static void tail_wheel_always_any(int64_t n, const double **p, double **y)
{
    tail_wheel_always_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], y[0], y[1]);
}

SHOWN void sweep_tail_wheel_always(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(tail_wheel_always_any, 8, 2, n, threads, p, stride, y);
}

static void gear_position_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p7[i];
        const double w1 = 0.5;
        const double w2 = p4[i];
        const double w3 = w1 * w2;
        const double w4 = p5[i];
        const double w5 = w3 * w4;
        const double w6 = p3[i];
        const double w7 = w5 * w6;
        const double w8 = p2[i];
        const double w9 = w8 * w8;
        const double w10 = w7 * w9;
        const double w11 = w0 + w10;
        const double w12 = 2.0 * w11;
        const double w13 = p1[i];
        const double w14 = w12 * w13;
        const double w15 = p6[i];
        const double w16 = 2.0 * w15;
        const double w17 = w16 * w13;
        const double w18 = p0[i];
        const double w19 = w8 * w8;
        const double w20 = w18 * w19;
        const double w21 = w17 + w20;
        const double w22 = w14 * w21;
        const double w23 = 2.0 * w22;
        const double w24 = -4.0;
        const double w25 = w24 * w22;
        const double w26 = 4.0;
        const double w27 = w26 * w15;
        const double w28 = w27 * w11;
        const double w29 = w25 * w28;
        const double w30 = w24 * w15;
        const double w31 = w8 * w8;
        const double w32 = w18 * w31;
        const double w33 = w32 - w14;
        const double w34 = w30 * w33;
        const double w35 = w34 * w34;
        const double w36 = w29 + w35;
        const double w37 = sqrt(w36);
        const double w38 = w37 - w34;
        const double w39 = w23 / w38;
        y0[i] = w39;
        const double w41 = w1 * w38;
        const double w42 = w41 / w28;
        y1[i] = w42;
    }
}

static void gear_position_any(int64_t n, const double **p, double **y)
{
    gear_position_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], y[0], y[1]);
}

SHOWN void sweep_gear_position(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(gear_position_any, 8, 2, n, threads, p, stride, y);
}

static void gear_position_envelope_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p1[i];
        const double w1 = p5[i];
        const double w2 = 2.0 * w1;
        const double w3 = sqrt(w2);
        const double w4 = w0 * w3;
        const double w5 = 0.5;
        const double w6 = p3[i];
        const double w7 = w5 * w6;
        const double w8 = p4[i];
        const double w9 = w7 * w8;
        const double w10 = p2[i];
        const double w11 = w9 * w10;
        const double w12 = sqrt(w11);
        const double w13 = w4 * w12;
        const double w14 = p6[i];
        const double w15 = sqrt(w14);
        const double w16 = sqrt(w0);
        const double w17 = w15 * w16;
        const double w18 = p0[i];
        const double w19 = sqrt(w18);
        const double w20 = w17 * w19;
        const double w21 = w13 + w20;
        const double w22 = 2.0 * w21;
        const double w23 = w3 * w19;
        const double w24 = -4.0;
        const double w25 = w24 * w21;
        const double w26 = w3 * w12;
        const double w27 = w25 * w26;
        const double w28 = w23 * w23;
        const double w29 = w27 + w28;
        const double w30 = sqrt(w29);
        const double w31 = w23 + w30;
        const double w32 = w22 / w31;
        const double w33 = w32 * w32;
        y0[i] = w33;
        const double w35 = w3 * w15;
        const double w36 = w33 + w0;
        const double w37 = w35 * w36;
        const double w38 = w12 * w16;
        const double w39 = w38 * w19;
        const double w40 = w37 / w39;
        const double w41 = sqrt(w40);
        y1[i] = w41;
    }
}

static void gear_position_envelope_any(int64_t n, const double **p, double **y)
{
    gear_position_envelope_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], y[0], y[1]);
}

SHOWN void sweep_gear_position_envelope(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(gear_position_envelope_any, 7, 2, n, threads, p, stride, y);
}

static void loaded_gear_position_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, const double *restrict p10, const double *restrict p11, const double *restrict p12, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p1[i];
        const double w1 = p8[i];
        const double w2 = w0 * w1;
        const double w3 = 0.5;
        const double w4 = p4[i];
        const double w5 = w3 * w4;
        const double w6 = p5[i];
        const double w7 = w5 * w6;
        const double w8 = p3[i];
        const double w9 = w7 * w8;
        const double w10 = w2 * w9;
        const double w11 = p6[i];
        const double w12 = 2.0 * w11;
        const double w13 = p7[i];
        const double w14 = w13 * w1;
        const double w15 = p0[i];
        const double w16 = w14 * w15;
        const double w17 = w12 + w16;
        const double w18 = w10 * w17;
        const double w19 = p2[i];
        const double w20 = w19 * w19;
        const double w21 = w18 * w20;
        const double w22 = 2.0 * w9;
        const double w23 = w19 * w19;
        const double w24 = w23 * w23;
        const double w25 = w22 * w24;
        const double w26 = w21 + w25;
        y0[i] = w26;
        const double w28 = p9[i];
        const double w29 = w28 * w0;
        const double w30 = w1 * w1;
        const double w31 = w29 * w30;
        const double w32 = w31 * w15;
        const double w33 = w32 * w17;
        const double w34 = w1 * w15;
        const double w35 = w13 * w0;
        const double w36 = w35 * w1;
        const double w37 = w36 * w9;
        const double w38 = 2.0 * w28;
        const double w39 = w37 - w38;
        const double w40 = w39 + w17;
        const double w41 = w34 * w40;
        const double w42 = w19 * w19;
        const double w43 = w41 * w42;
        const double w44 = w33 - w43;
        const double w45 = -2.0;
        const double w46 = w45 * w9;
        const double w47 = w19 * w19;
        const double w48 = w47 * w47;
        const double w49 = w46 * w48;
        const double w50 = w44 + w49;
        y1[i] = w50;
        const double w52 = w1 * w1;
        const double w53 = w1 * w52;
        const double w54 = w0 * w53;
        const double w55 = w15 * w15;
        const double w56 = w54 * w55;
        const double w57 = 2.0 * w11;
        const double w58 = p10[i];
        const double w59 = w57 * w58;
        const double w60 = w13 * w28;
        const double w61 = w59 - w60;
        const double w62 = w13 * w58;
        const double w63 = w62 * w1;
        const double w64 = w63 * w15;
        const double w65 = w61 + w64;
        const double w66 = w56 * w65;
        const double w67 = 2.0 * w1;
        const double w68 = w67 * w15;
        const double w69 = w11 - w28;
        const double w70 = w58 * w1;
        const double w71 = w70 * w15;
        const double w72 = w69 + w71;
        const double w73 = w72 + w16;
        const double w74 = w68 * w73;
        const double w75 = w19 * w19;
        const double w76 = w74 * w75;
        const double w77 = w66 + w76;
        y2[i] = w77;
        const double w79 = w1 * w1;
        const double w80 = w79 * w79;
        const double w81 = w0 * w80;
        const double w82 = w15 * w15;
        const double w83 = w15 * w82;
        const double w84 = w81 * w83;
        const double w85 = 2.0 * w11;
        const double w86 = p11[i];
        const double w87 = w85 * w86;
        const double w88 = w13 * w58;
        const double w89 = w87 - w88;
        const double w90 = w13 * w86;
        const double w91 = w90 * w1;
        const double w92 = w91 * w15;
        const double w93 = w89 + w92;
        const double w94 = w84 * w93;
        const double w95 = w1 * w1;
        const double w96 = w15 * w15;
        const double w97 = w95 * w96;
        const double w98 = 2.0 * w86;
        const double w99 = w98 * w1;
        const double w100 = w99 * w15;
        const double w101 = 2.0 * w58;
        const double w102 = w13 + w101;
        const double w103 = w100 - w102;
        const double w104 = w97 * w103;
        const double w105 = w19 * w19;
        const double w106 = w104 * w105;
        const double w107 = w94 + w106;
        y3[i] = w107;
        const double w109 = w1 * w1;
        const double w110 = w109 * w109;
        const double w111 = w1 * w110;
        const double w112 = w0 * w111;
        const double w113 = w15 * w15;
        const double w114 = w113 * w113;
        const double w115 = w112 * w114;
        const double w116 = 2.0 * w11;
        const double w117 = p12[i];
        const double w118 = w116 * w117;
        const double w119 = w13 * w86;
        const double w120 = w118 - w119;
        const double w121 = w117 * w16;
        const double w122 = w120 + w121;
        const double w123 = w115 * w122;
        const double w124 = w1 * w1;
        const double w125 = w1 * w124;
        const double w126 = 2.0 * w125;
        const double w127 = w15 * w15;
        const double w128 = w15 * w127;
        const double w129 = w126 * w128;
        const double w130 = w117 * w1;
        const double w131 = w130 * w15;
        const double w132 = w131 - w86;
        const double w133 = w129 * w132;
        const double w134 = w19 * w19;
        const double w135 = w133 * w134;
        const double w136 = w123 + w135;
        y4[i] = w136;
        const double w138 = w45 * w117;
        const double w139 = w1 * w1;
        const double w140 = w139 * w139;
        const double w141 = w138 * w140;
        const double w142 = w15 * w15;
        const double w143 = w142 * w142;
        const double w144 = w141 * w143;
        const double w145 = w19 * w19;
        const double w146 = w144 * w145;
        const double w147 = w13 * w117;
        const double w148 = w147 * w0;
        const double w149 = w1 * w1;
        const double w150 = w1 * w149;
        const double w151 = w150 * w150;
        const double w152 = w148 * w151;
        const double w153 = w15 * w15;
        const double w154 = w153 * w153;
        const double w155 = w15 * w154;
        const double w156 = w152 * w155;
        const double w157 = w146 - w156;
        y5[i] = w157;
    }
}

static void loaded_gear_position_any(int64_t n, const double **p, double **y)
{
    loaded_gear_position_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], y[0], y[1], y[2], y[3], y[4], y[5]);
}

SHOWN void sweep_loaded_gear_position(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(loaded_gear_position_any, 13, 6, n, threads, p, stride, y);
}

static void loaded_gear_envelope_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, const double *restrict p10, const double *restrict p11, double *y0, double *y1, double *y2, double *y3, double *y4, double *y5, double *y6, double *y7, double *y8, double *y9, double *y10)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p1[i];
        const double w1 = p7[i];
        const double w2 = w0 * w1;
        const double w3 = 0.5;
        const double w4 = p3[i];
        const double w5 = w3 * w4;
        const double w6 = p4[i];
        const double w7 = w5 * w6;
        const double w8 = p2[i];
        const double w9 = w7 * w8;
        const double w10 = w2 * w9;
        const double w11 = p5[i];
        const double w12 = 2.0 * w11;
        const double w13 = p6[i];
        const double w14 = w13 * w1;
        const double w15 = p0[i];
        const double w16 = w14 * w15;
        const double w17 = w12 + w16;
        const double w18 = w10 * w17;
        const double w19 = w18 * w18;
        y0[i] = w19;
        const double w21 = 4.0;
        const double w22 = p8[i];
        const double w23 = w22 * w0;
        const double w24 = w1 * w1;
        const double w25 = w23 * w24;
        const double w26 = w25 * w15;
        const double w27 = w26 * w17;
        const double w28 = w21 * w27;
        const double w29 = 2.0 * w9;
        const double w30 = w28 * w29;
        const double w31 = 2.0 * w18;
        const double w32 = w1 * w15;
        const double w33 = w13 * w0;
        const double w34 = w33 * w1;
        const double w35 = w34 * w9;
        const double w36 = 2.0 * w22;
        const double w37 = w35 - w36;
        const double w38 = w37 + w17;
        const double w39 = w32 * w38;
        const double w40 = w31 * w39;
        const double w41 = w30 + w40;
        const double w42 = -w41;
        y1[i] = w42;
        const double w44 = -4.0;
        const double w45 = w44 * w27;
        const double w46 = -2.0;
        const double w47 = w46 * w9;
        const double w48 = w45 * w47;
        const double w49 = w1 * w1;
        const double w50 = w1 * w49;
        const double w51 = w0 * w50;
        const double w52 = w15 * w15;
        const double w53 = w51 * w52;
        const double w54 = 2.0 * w11;
        const double w55 = p9[i];
        const double w56 = w54 * w55;
        const double w57 = w13 * w22;
        const double w58 = w56 - w57;
        const double w59 = w13 * w55;
        const double w60 = w59 * w1;
        const double w61 = w60 * w15;
        const double w62 = w58 + w61;
        const double w63 = w53 * w62;
        const double w64 = w21 * w63;
        const double w65 = w64 * w29;
        const double w66 = w48 - w65;
        const double w67 = 2.0 * w18;
        const double w68 = 2.0 * w1;
        const double w69 = w68 * w15;
        const double w70 = w11 - w22;
        const double w71 = w55 * w1;
        const double w72 = w71 * w15;
        const double w73 = w70 + w72;
        const double w74 = w73 + w16;
        const double w75 = w69 * w74;
        const double w76 = w67 * w75;
        const double w77 = w66 + w76;
        const double w78 = w39 * w39;
        const double w79 = w77 + w78;
        y2[i] = w79;
        const double w81 = w44 * w63;
        const double w82 = w81 * w47;
        const double w83 = w1 * w1;
        const double w84 = w83 * w83;
        const double w85 = w0 * w84;
        const double w86 = w15 * w15;
        const double w87 = w15 * w86;
        const double w88 = w85 * w87;
        const double w89 = 2.0 * w11;
        const double w90 = p10[i];
        const double w91 = w89 * w90;
        const double w92 = w13 * w55;
        const double w93 = w91 - w92;
        const double w94 = w13 * w90;
        const double w95 = w94 * w1;
        const double w96 = w95 * w15;
        const double w97 = w93 + w96;
        const double w98 = w88 * w97;
        const double w99 = w21 * w98;
        const double w100 = w99 * w29;
        const double w101 = w82 - w100;
        const double w102 = 2.0 * w18;
        const double w103 = w1 * w1;
        const double w104 = w15 * w15;
        const double w105 = w103 * w104;
        const double w106 = 2.0 * w90;
        const double w107 = w106 * w1;
        const double w108 = w107 * w15;
        const double w109 = 2.0 * w55;
        const double w110 = w13 + w109;
        const double w111 = w108 - w110;
        const double w112 = w105 * w111;
        const double w113 = w102 * w112;
        const double w114 = w101 + w113;
        const double w115 = -w39;
        const double w116 = 2.0 * w115;
        const double w117 = w116 * w75;
        const double w118 = w114 + w117;
        y3[i] = w118;
        const double w120 = w44 * w98;
        const double w121 = w120 * w47;
        const double w122 = w1 * w1;
        const double w123 = w122 * w122;
        const double w124 = w1 * w123;
        const double w125 = w0 * w124;
        const double w126 = w15 * w15;
        const double w127 = w126 * w126;
        const double w128 = w125 * w127;
        const double w129 = 2.0 * w11;
        const double w130 = p11[i];
        const double w131 = w129 * w130;
        const double w132 = w13 * w90;
        const double w133 = w131 - w132;
        const double w134 = w130 * w16;
        const double w135 = w133 + w134;
        const double w136 = w128 * w135;
        const double w137 = w21 * w136;
        const double w138 = w137 * w29;
        const double w139 = w121 - w138;
        const double w140 = 2.0 * w18;
        const double w141 = w1 * w1;
        const double w142 = w1 * w141;
        const double w143 = 2.0 * w142;
        const double w144 = w15 * w15;
        const double w145 = w15 * w144;
        const double w146 = w143 * w145;
        const double w147 = w130 * w1;
        const double w148 = w147 * w15;
        const double w149 = w148 - w90;
        const double w150 = w146 * w149;
        const double w151 = w140 * w150;
        const double w152 = w139 + w151;
        const double w153 = 2.0 * w115;
        const double w154 = w153 * w112;
        const double w155 = w152 + w154;
        const double w156 = w75 * w75;
        const double w157 = w155 + w156;
        y4[i] = w157;
        const double w159 = w44 * w136;
        const double w160 = w159 * w47;
        const double w161 = w13 * w130;
        const double w162 = w161 * w0;
        const double w163 = w1 * w1;
        const double w164 = w1 * w163;
        const double w165 = w164 * w164;
        const double w166 = w162 * w165;
        const double w167 = w15 * w15;
        const double w168 = w167 * w167;
        const double w169 = w15 * w168;
        const double w170 = w166 * w169;
        const double w171 = w21 * w170;
        const double w172 = w171 * w29;
        const double w173 = w160 + w172;
        const double w174 = 2.0 * w18;
        const double w175 = w46 * w130;
        const double w176 = w1 * w1;
        const double w177 = w176 * w176;
        const double w178 = w175 * w177;
        const double w179 = w15 * w15;
        const double w180 = w179 * w179;
        const double w181 = w178 * w180;
        const double w182 = w174 * w181;
        const double w183 = w173 + w182;
        const double w184 = 2.0 * w115;
        const double w185 = w184 * w150;
        const double w186 = w183 + w185;
        const double w187 = 2.0 * w75;
        const double w188 = w187 * w112;
        const double w189 = w186 + w188;
        y5[i] = w189;
        const double w191 = 2.0 * w115;
        const double w192 = w191 * w181;
        const double w193 = w44 * w170;
        const double w194 = w193 * w47;
        const double w195 = w192 - w194;
        const double w196 = 2.0 * w75;
        const double w197 = w196 * w150;
        const double w198 = w195 + w197;
        const double w199 = w112 * w112;
        const double w200 = w198 + w199;
        y6[i] = w200;
        const double w202 = 2.0 * w75;
        const double w203 = w202 * w181;
        const double w204 = 2.0 * w112;
        const double w205 = w204 * w150;
        const double w206 = w203 + w205;
        y7[i] = w206;
        const double w208 = 2.0 * w112;
        const double w209 = w208 * w181;
        const double w210 = w150 * w150;
        const double w211 = w209 + w210;
        y8[i] = w211;
        const double w213 = 2.0 * w150;
        const double w214 = w213 * w181;
        y9[i] = w214;
        const double w216 = w181 * w181;
        y10[i] = w216;
    }
}

static void loaded_gear_envelope_any(int64_t n, const double **p, double **y)
{
    loaded_gear_envelope_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7], y[8], y[9], y[10]);
}

SHOWN void sweep_loaded_gear_envelope(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(loaded_gear_envelope_any, 12, 11, n, threads, p, stride, y);
}

static void at_tail_load_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, const double *restrict p10, const double *restrict p11, const double *restrict p12, double *y0, double *y1)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p2[i];
        const double w1 = p0[i];
        const double w2 = w0 * w1;
        const double w3 = 1.0;
        const double w4 = w1 - w3;
        const double w5 = w2 / w4;
        const double w6 = -w5;
        y0[i] = w6;
        const double w8 = p8[i];
        const double w9 = p1[i];
        const double w10 = w8 * w9;
        const double w11 = p7[i];
        const double w12 = w0 * w8;
        const double w13 = 0.5;
        const double w14 = p4[i];
        const double w15 = w13 * w14;
        const double w16 = p5[i];
        const double w17 = w15 * w16;
        const double w18 = p3[i];
        const double w19 = w17 * w18;
        const double w20 = w12 * w19;
        const double w21 = w11 * w20;
        const double w22 = p9[i];
        const double w23 = 2.0 * w22;
        const double w24 = w21 - w23;
        const double w25 = p6[i];
        const double w26 = 2.0 * w25;
        const double w27 = w11 * w8;
        const double w28 = w27 * w9;
        const double w29 = w26 + w28;
        const double w30 = w24 + w29;
        const double w31 = w10 * w30;
        const double w32 = w31 * w1;
        const double w33 = w29 * w20;
        const double w34 = w32 - w33;
        const double w35 = 2.0 * w8;
        const double w36 = w35 * w9;
        const double w37 = w25 - w22;
        const double w38 = p10[i];
        const double w39 = w38 * w8;
        const double w40 = w39 * w9;
        const double w41 = w37 + w40;
        const double w42 = w41 + w28;
        const double w43 = w36 * w42;
        const double w44 = w1 * w1;
        const double w45 = w43 * w44;
        const double w46 = w34 - w45;
        const double w47 = w8 * w8;
        const double w48 = w9 * w9;
        const double w49 = w47 * w48;
        const double w50 = p11[i];
        const double w51 = 2.0 * w50;
        const double w52 = w51 * w8;
        const double w53 = w52 * w9;
        const double w54 = 2.0 * w38;
        const double w55 = w11 + w54;
        const double w56 = w53 - w55;
        const double w57 = w49 * w56;
        const double w58 = w1 * w1;
        const double w59 = w1 * w58;
        const double w60 = w57 * w59;
        const double w61 = w46 - w60;
        const double w62 = w8 * w8;
        const double w63 = w8 * w62;
        const double w64 = 2.0 * w63;
        const double w65 = w9 * w9;
        const double w66 = w9 * w65;
        const double w67 = w64 * w66;
        const double w68 = p12[i];
        const double w69 = w68 * w8;
        const double w70 = w69 * w9;
        const double w71 = w70 - w50;
        const double w72 = w67 * w71;
        const double w73 = w1 * w1;
        const double w74 = w73 * w73;
        const double w75 = w72 * w74;
        const double w76 = w61 - w75;
        const double w77 = -2.0;
        const double w78 = w77 * w68;
        const double w79 = w8 * w8;
        const double w80 = w79 * w79;
        const double w81 = w78 * w80;
        const double w82 = w9 * w9;
        const double w83 = w82 * w82;
        const double w84 = w81 * w83;
        const double w85 = w1 * w1;
        const double w86 = w85 * w85;
        const double w87 = w1 * w86;
        const double w88 = w84 * w87;
        const double w89 = w76 - w88;
        const double w90 = 4.0;
        const double w91 = w90 * w19;
        const double w92 = -4.0;
        const double w93 = w92 * w19;
        const double w94 = w93 * w1;
        const double w95 = w91 + w94;
        const double w96 = w89 / w95;
        const double w97 = sqrt(w96);
        y1[i] = w97;
    }
}

static void at_tail_load_any(int64_t n, const double **p, double **y)
{
    at_tail_load_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], y[0], y[1]);
}

SHOWN void sweep_at_tail_load(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(at_tail_load_any, 13, 2, n, threads, p, stride, y);
}

static void toe_effects_block(int64_t n, const double *restrict p0, const double *restrict p1, const double *restrict p2, const double *restrict p3, const double *restrict p4, const double *restrict p5, const double *restrict p6, const double *restrict p7, const double *restrict p8, const double *restrict p9, const double *restrict p10, const double *restrict p11, const double *restrict p12, const double *restrict p13, const double *restrict p14, double *y0, double *y1, double *y2, double *y3)
{
    _Pragma("omp simd")
    for (int64_t i = 0; i < n; ++i) {
        const double w0 = p8[i];
        const double w1 = p14[i];
        const double w2 = w0 * w1;
        y0[i] = w2;
        const double w4 = p11[i];
        const double w5 = p12[i];
        const double w6 = 2.0 * w5;
        const double w7 = p10[i];
        const double w8 = w6 * w7;
        const double w9 = w4 + w8;
        const double w10 = 2.0 * w9;
        const double w11 = p2[i];
        const double w12 = w10 * w11;
        const double w13 = p13[i];
        const double w14 = w12 * w13;
        const double w15 = 2.0 * w0;
        const double w16 = p9[i];
        const double w17 = 0.5;
        const double w18 = p6[i];
        const double w19 = w17 * w18;
        const double w20 = p7[i];
        const double w21 = w19 * w20;
        const double w22 = p5[i];
        const double w23 = w21 * w22;
        const double w24 = p4[i];
        const double w25 = w24 * w24;
        const double w26 = w23 * w25;
        const double w27 = w16 + w26;
        const double w28 = w15 + w27;
        const double w29 = w14 * w28;
        const double w30 = w29 / w1;
        y1[i] = w30;
        const double w32 = w2 - w30;
        y2[i] = w32;
        const double w34 = 4.0;
        const double w35 = w34 * w0;
        const double w36 = w35 * w9;
        const double w37 = w36 * w11;
        const double w38 = w37 * w13;
        const double w39 = p0[i];
        const double w40 = w38 * w39;
        const double w41 = w24 * w24;
        const double w42 = w40 * w41;
        const double w43 = w0 * w27;
        const double w44 = w43 * w11;
        const double w45 = w1 * w1;
        const double w46 = w44 * w45;
        const double w47 = w42 + w46;
        const double w48 = w0 * w27;
        const double w49 = p3[i];
        const double w50 = w48 * w49;
        const double w51 = w1 * w1;
        const double w52 = w50 * w51;
        const double w53 = w47 + w52;
        const double w54 = w0 * w39;
        const double w55 = w1 * w1;
        const double w56 = w54 * w55;
        const double w57 = w24 * w24;
        const double w58 = w56 * w57;
        const double w59 = w53 - w58;
        const double w60 = 2.0 * w9;
        const double w61 = w60 * w27;
        const double w62 = w61 * w11;
        const double w63 = w62 * w13;
        const double w64 = w63 * w39;
        const double w65 = w24 * w24;
        const double w66 = w64 * w65;
        const double w67 = w59 + w66;
        const double w68 = 8.0;
        const double w69 = w68 * w27;
        const double w70 = w69 * w11;
        const double w71 = w70 * w49;
        const double w72 = w0 * w9;
        const double w73 = w72 * w13;
        const double w74 = w71 * w73;
        const double w75 = w67 - w74;
        const double w76 = w11 * w11;
        const double w77 = w34 * w27;
        const double w78 = w77 * w73;
        const double w79 = w76 * w78;
        const double w80 = w75 - w79;
        const double w81 = w49 * w49;
        const double w82 = w81 * w78;
        const double w83 = w80 - w82;
        const double w84 = p1[i];
        const double w85 = w84 * w39;
        const double w86 = w85 * w1;
        const double w87 = w24 * w24;
        const double w88 = w86 * w87;
        const double w89 = w83 / w88;
        const double w90 = -w89;
        y3[i] = w90;
    }
}

static void toe_effects_any(int64_t n, const double **p, double **y)
{
    toe_effects_block(n, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], p[13], p[14], y[0], y[1], y[2], y[3]);
}

SHOWN void sweep_toe_effects(int64_t n, int64_t threads, const double *const *p,
    const int64_t *stride, double *const *y)
{
    sweep(toe_effects_any, 15, 4, n, threads, p, stride, y);
}
