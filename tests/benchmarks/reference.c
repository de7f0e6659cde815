/* The same model in 80-bit arithmetic with the C library's functions, for the errors. */
#include <math.h>
#include <stdint.h>
#include "constants.h"

typedef long double real;

static void rates(double a, double Ct, double u, const real *x, real *f)
{
    const real slip = (B3 + (real)C3 * FZ) * ((x[0] + a * x[1]) / u) / (B5 + (real)C5 * FZ);
    const real psi = (1 - (real)E1) * slip + (real)E1 / B1 * atanl(B1 * slip);
    const real main = 2 * (real)D1 * sinl(C1 * atanl(B1 * psi)) * (B5 + (real)C5 * FZ) * FZ;
    const real tail = (0.5L * RHO * u * u * AP * CL_GAMMA + Ct) * atanl((x[0] - ARM_B * x[1]) / u);
    f[0] = (-main - tail) / MASS - u * x[1];
    f[1] = (-a * main + ARM_B * tail) / IZZ;
    f[2] = x[0];
    f[3] = x[1];
}

static void run(double a, double Ct, double u, double v0, int64_t n, int64_t sub, double *out, double *scale)
{
    real x[4] = {v0, 0, 0, 0}, w[4], k[12][4];
    const real h = (real)T_END / ((n - 1) * sub);
    for (int i = 0; i < 4; ++i) scale[i] = fabsl(x[i]);
    for (int64_t o = 0; o < n; ++o) {
        for (int i = 0; i < 4; ++i) out[4 * o + i] = x[i];
        if (o == n - 1) break;
        for (int64_t m = 0; m < sub; ++m) {
            for (int s = 0; s < 12; ++s) {
                for (int i = 0; i < 4; ++i) {
                    real z = 0;
                    for (int j = 0; j < s; ++j) z += (real)A_TABLE[s][j] * k[j][i];
                    w[i] = x[i] + h * z;
                }
                rates(a, Ct, u, w, k[s]);
            }
            for (int i = 0; i < 4; ++i) {
                real z = 0;
                for (int j = 0; j < 12; ++j) z += (real)B_TABLE[j] * k[j][i];
                x[i] += h * z;
                if (fabsl(x[i]) > scale[i]) scale[i] = fabsl(x[i]);
            }
        }
    }
}

void reference_single(double a, double Ct, double u, double v0, int64_t n, int64_t sub, double *out, double *scale)
{
    run(a, Ct, u, v0, n, sub, out, scale);
}

void reference_ensemble(int64_t n, const double *a, const double *Ct, const double *u, const double *v0, int64_t steps, double *final, double *scale)
{
#pragma omp parallel for schedule(dynamic, 16)
    for (int64_t i = 0; i < n; ++i) {
        double ends[8];
        /* two outputs only, so the scales come from every step and the end from the last */
        run(a[i], Ct[i], u[i], v0[i], 2, steps, ends, scale + 4 * i);
        for (int j = 0; j < 4; ++j) final[4 * i + j] = ends[4 + j];
    }
}
