/// One MUSL step in two dimensions, written by hand and without the toolkit: the yardstick for step.cpp. Structure of arrays, a node
/// struct, weights recomputed in each of the three passes, particles in cell order, FLIP, nothing held; the sums run in the order of
/// musl.hpp. Several threads take strips of particles, first the even ones, then the odd ones, as long as no particle leaves its strip by
/// more than a cell row.
#pragma once
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace by_hand {

enum class Law { linear_elastic, neo_hookean };

struct Node {
    double m, px, py, qx, qy, fx, fy, vx, vy, wx, wy, tx,
        ty;  // mass; momentum, new one; force; velocity, new one, before the second mapping
};

struct Particles {
    std::vector<double> m, V0, V, x, y, vx, vy, F00, F01, F10, F11, sxx, sxy, syy;
    void resize(std::size_t n) {
        for (auto* a : {&m, &V0, &V, &x, &y, &vx, &vy, &F00, &F01, &F10, &F11, &sxx, &sxy, &syy}) a->resize(n);
    }
};

struct Square {
    double x0 = 0, y0 = 0, h = 1;  // lower corner, cell size
    int cells_x = 0, cells_y = 0;
    double lambda = 0, mu = 0;
    Particles p;
    std::vector<Node> nodes;
    int threads = 1;
    std::vector<std::size_t> strips;  // first particle of each strip of `rows` cell rows, and the number of particles
    static constexpr int rows = 6;

    void cut() {
        strips.assign(static_cast<std::size_t>((cells_y + rows - 1) / rows) + 1, 0);
        for (const double at : p.y) ++strips[static_cast<std::size_t>((at - y0) / h) / rows + 1];
        for (std::size_t k = 1; k < strips.size(); ++k) strips[k] += strips[k - 1];
    }
};

/// pass(first, last) adds to nodes for a range of particles.
template <class Pass> void coloured(const Square& s, Pass&& pass) {
    if (s.threads == 1) return pass(0, s.p.x.size());
    const int strips = static_cast<int>(s.strips.size()) - 1;
#pragma omp parallel num_threads(s.threads)
    for (int colour = 0; colour < 2; ++colour) {
#pragma omp for schedule(static)
        for (int k = colour; k < strips; k += 2) pass(s.strips[static_cast<std::size_t>(k)], s.strips[static_cast<std::size_t>(k) + 1]);
    }
}

/// pass(first, last) reads the nodes only, or is for a range of nodes.
template <class Pass> void shared(int threads, std::size_t count, Pass&& pass) {
    if (threads == 1) return pass(0, count);
    const auto parts = static_cast<std::size_t>(threads);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::size_t k = 0; k < parts; ++k) pass(count * k / parts, count * (k + 1) / parts);
}

inline void clear(Square& s) {
    shared(s.threads, s.nodes.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t I = first; I < last; ++I) s.nodes[I] = Node{};
    });
}

inline void new_momenta(Square& s, double dt) {
    shared(s.threads, s.nodes.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t I = first; I < last; ++I) {
            Node& n = s.nodes[I];
            const double qx = n.px + dt * n.fx, qy = n.py + dt * n.fy;
            const bool mass = n.m > 0;
            n.vx = mass ? n.px / n.m : 0;
            n.vy = mass ? n.py / n.m : 0;
            n.wx = n.tx = mass ? qx / n.m : 0;
            n.wy = n.ty = mass ? qy / n.m : 0;
            n.qx = n.qy = 0;
        }
    });
}

inline void mapped_velocities(Square& s) {
    shared(s.threads, s.nodes.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t I = first; I < last; ++I) {
            Node& n = s.nodes[I];
            const bool mass = n.m > 0;
            n.wx = mass ? n.qx / n.m : 0;
            n.wy = mass ? n.qy / n.m : 0;
        }
    });
}

/// Moves particle i and updates its stress from the grid velocity (vx, vy) and its gradient.
template <Law law> inline void update(Particles& p, std::size_t i, double lambda, double mu, double dt, double vx, double vy, double L00,
                                      double L01, double L10, double L11) {
    p.x[i] += dt * vx;
    p.y[i] += dt * vy;
    const double a = p.F00[i], b = p.F01[i], c = p.F10[i], d = p.F11[i];
    const double F00 = a + (dt * L00 * a + dt * L01 * c), F01 = b + (dt * L00 * b + dt * L01 * d);
    const double F10 = c + (dt * L10 * a + dt * L11 * c), F11 = d + (dt * L10 * b + dt * L11 * d);
    p.F00[i] = F00, p.F01[i] = F01, p.F10[i] = F10, p.F11[i] = F11;
    const double J = F00 * F11 - F01 * F10;
    p.V[i] = J * p.V0[i];
    if constexpr (law == Law::linear_elastic) {
        const double exx = dt * L00, eyy = dt * L11, exy = dt * (0.5 * (L01 + L10));
        const double pressure = lambda * (exx + eyy);
        p.sxx[i] += pressure + 2 * mu * exx;
        p.syy[i] += pressure + 2 * mu * eyy;
        p.sxy[i] += 2 * mu * exy;
    } else {
        const double l = lambda * std::log(J);
        p.sxx[i] = (mu * (F00 * F00 + F01 * F01 - 1) + l) / J;
        p.syy[i] = (mu * (F10 * F10 + F11 * F11 - 1) + l) / J;
        p.sxy[i] = mu * (F00 * F10 + F01 * F11) / J;
    }
}

/// Hat functions, 4 nodes.
template <Law law> void step_hat(Square& s, double dt) {
    Particles& p = s.p;
    const std::size_t count = p.x.size();
    const int row = s.cells_x + 1;
    const double r = 1 / s.h, x0 = s.x0, y0 = s.y0;
    Node* const nodes = s.nodes.data();
    clear(s);
    coloured(s, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r, Y = (p.y[i] - y0) * r;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            const double x1 = X - I, x2 = 1 - x1, y1 = Y - J, y2 = 1 - y1;
            const double w[4] = {x2 * y2, x1 * y2, x2 * y1, x1 * y1};
            const double gx[4] = {-r * y2, r * y2, -r * y1, r * y1}, gy[4] = {-r * x2, -r * x1, r * x2, r * x1};
            Node* const at[4] = {nodes + J * row + I, nodes + J * row + I + 1, nodes + (J + 1) * row + I, nodes + (J + 1) * row + I + 1};
            const double m = p.m[i], vx = p.vx[i], vy = p.vy[i], V = p.V[i];
            const double sxx = V * p.sxx[i], sxy = V * p.sxy[i], syy = V * p.syy[i];
            for (int k = 0; k < 4; ++k) {
                Node& n = *at[k];
                const double mass = w[k] * m;
                n.m += mass;
                n.px += mass * vx;
                n.py += mass * vy;
                n.fx -= sxx * gx[k] + sxy * gy[k];
                n.fy -= sxy * gx[k] + syy * gy[k];
            }
        }
    });
    new_momenta(s, dt);
    coloured(s, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r, Y = (p.y[i] - y0) * r;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            const double x1 = X - I, x2 = 1 - x1, y1 = Y - J, y2 = 1 - y1;
            const double w[4] = {x2 * y2, x1 * y2, x2 * y1, x1 * y1};
            Node* const at[4] = {nodes + J * row + I, nodes + J * row + I + 1, nodes + (J + 1) * row + I, nodes + (J + 1) * row + I + 1};
            double vx = p.vx[i], vy = p.vy[i];
            for (int k = 0; k < 4; ++k) {
                vx += w[k] * (at[k]->wx - at[k]->vx);
                vy += w[k] * (at[k]->wy - at[k]->vy);
            }
            p.vx[i] = vx;
            p.vy[i] = vy;
            const double m = p.m[i];
            for (int k = 0; k < 4; ++k) {
                const double mass = w[k] * m;
                at[k]->qx += mass * vx;
                at[k]->qy += mass * vy;
            }
        }
    });
    mapped_velocities(s);
    shared(s.threads, count, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r, Y = (p.y[i] - y0) * r;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            const double x1 = X - I, x2 = 1 - x1, y1 = Y - J, y2 = 1 - y1;
            const double w[4] = {x2 * y2, x1 * y2, x2 * y1, x1 * y1};
            const double gx[4] = {-r * y2, r * y2, -r * y1, r * y1}, gy[4] = {-r * x2, -r * x1, r * x2, r * x1};
            const Node* const at[4] = {nodes + J * row + I, nodes + J * row + I + 1, nodes + (J + 1) * row + I,
                                       nodes + (J + 1) * row + I + 1};
            double vx = 0, vy = 0, L00 = 0, L01 = 0, L10 = 0, L11 = 0;
            for (int k = 0; k < 4; ++k) {
                const Node& n = *at[k];
                vx += w[k] * n.tx;
                vy += w[k] * n.ty;
                L00 += n.wx * gx[k];
                L01 += n.wx * gy[k];
                L10 += n.wy * gx[k];
                L11 += n.wy * gy[k];
            }
            update<law>(p, i, s.lambda, s.mu, dt, vx, vy, L00, L01, L10, L11);
        }
    });
}

/// Weights and slopes of the B-spline over N = 3 or 4 nodes, r in cells: quadratic, from the left node less one half; cubic, from the
/// second node.
template <int N> void spline(double r, double* w, double* dw) {
    if constexpr (N == 3) {
        w[0] = 0.5 * (1 - r) * (1 - r), w[1] = 0.5 + r - r * r, w[2] = 0.5 * r * r;
        dw[0] = r - 1, dw[1] = 1 - 2 * r, dw[2] = r;
    } else {
        const double q = 1 - r, r3 = r * r * r / 6, q3 = q * q * q / 6;
        w[0] = q3, w[1] = 2.0 / 3 - r * r + 3 * r3, w[2] = 2.0 / 3 - q * q + 3 * q3, w[3] = r3;
        dw[0] = -0.5 * q * q, dw[1] = r * (1.5 * r - 2), dw[2] = q * (2 - 1.5 * q), dw[3] = 0.5 * r * r;
    }
}

/// Quadratic or cubic B-splines, N x N nodes, where no particle is within a cell of the grid's edge.
template <Law law, int N> void step_spline(Square& s, double dt) {
    Particles& p = s.p;
    const std::size_t count = p.x.size();
    const int row = s.cells_x + 1;
    constexpr double before = N == 3 ? 0.5 : 1;  // of the first node, where r is 0 [cells]
    const double r = 1 / s.h, x0 = s.x0, y0 = s.y0;
    Node* const nodes = s.nodes.data();
    clear(s);
    coloured(s, [&](std::size_t first, std::size_t last) {
        double u[N], du[N], v[N], dv[N];
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r - before, Y = (p.y[i] - y0) * r - before;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            spline<N>(X - I, u, du);
            spline<N>(Y - J, v, dv);
            const double m = p.m[i], vx = p.vx[i], vy = p.vy[i], V = p.V[i];
            const double sxx = V * p.sxx[i], sxy = V * p.sxy[i], syy = V * p.syy[i];
            for (int b = 0; b < N; ++b) {
                Node* const line = nodes + (J + b) * row + I;
                for (int a = 0; a < N; ++a) {
                    Node& n = line[a];
                    const double mass = u[a] * v[b] * m, gx = du[a] * r * v[b], gy = u[a] * dv[b] * r;
                    n.m += mass;
                    n.px += mass * vx;
                    n.py += mass * vy;
                    n.fx -= sxx * gx + sxy * gy;
                    n.fy -= sxy * gx + syy * gy;
                }
            }
        }
    });
    new_momenta(s, dt);
    coloured(s, [&](std::size_t first, std::size_t last) {
        double u[N], du[N], v[N], dv[N];
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r - before, Y = (p.y[i] - y0) * r - before;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            spline<N>(X - I, u, du);
            spline<N>(Y - J, v, dv);
            double vx = p.vx[i], vy = p.vy[i];
            for (int b = 0; b < N; ++b) {
                const Node* const line = nodes + (J + b) * row + I;
                for (int a = 0; a < N; ++a) {
                    const double w = u[a] * v[b];
                    vx += w * (line[a].wx - line[a].vx);
                    vy += w * (line[a].wy - line[a].vy);
                }
            }
            p.vx[i] = vx;
            p.vy[i] = vy;
            const double m = p.m[i];
            for (int b = 0; b < N; ++b) {
                Node* const line = nodes + (J + b) * row + I;
                for (int a = 0; a < N; ++a) {
                    const double mass = u[a] * v[b] * m;
                    line[a].qx += mass * vx;
                    line[a].qy += mass * vy;
                }
            }
        }
    });
    mapped_velocities(s);
    shared(s.threads, count, [&](std::size_t first, std::size_t last) {
        double u[N], du[N], v[N], dv[N];
        for (std::size_t i = first; i < last; ++i) {
            const double X = (p.x[i] - x0) * r - before, Y = (p.y[i] - y0) * r - before;
            const int I = static_cast<int>(X), J = static_cast<int>(Y);
            spline<N>(X - I, u, du);
            spline<N>(Y - J, v, dv);
            double vx = 0, vy = 0, L00 = 0, L01 = 0, L10 = 0, L11 = 0;
            for (int b = 0; b < N; ++b) {
                const Node* const line = nodes + (J + b) * row + I;
                for (int a = 0; a < N; ++a) {
                    const Node& n = line[a];
                    const double w = u[a] * v[b], gx = du[a] * r * v[b], gy = u[a] * dv[b] * r;
                    vx += w * n.tx;
                    vy += w * n.ty;
                    L00 += n.wx * gx;
                    L01 += n.wx * gy;
                    L10 += n.wy * gx;
                    L11 += n.wy * gy;
                }
            }
            update<law>(p, i, s.lambda, s.mu, dt, vx, vy, L00, L01, L10, L11);
        }
    });
}

}  // namespace by_hand
