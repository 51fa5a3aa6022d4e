/// Each kernel against its equations, and against its relatives.
#include <functional>

#include "tests/chapters/weighting/family.hpp"

namespace mpm::test {
namespace {

template <class Kernel> Tensor<1, Kernel> unit_shape(int cells, Kernel kernel = {}) {
    return {Lattice<1>(Vec<1>(0), Vec<1>(1), {cells}, Kernel::per_cell), kernel};
}

void expect_same(const Dense& a, const Dense& b, double tolerance, double gradient_tolerance) {
    ASSERT_EQ(a.phi.size(), b.phi.size());
    for (std::size_t I = 0; I < a.phi.size(); ++I) {
        EXPECT_NEAR(a.phi[I], b.phi[I], tolerance) << "node " << I;
        EXPECT_NEAR(a.grad[I], b.grad[I], gradient_tolerance) << "node " << I;
    }
}

/// Functions c(s) of nodes -2 ... cells + 2, folded by linear extrapolation past both ends.
Dense folded(int cells, const std::function<double(double)>& phi, const std::function<double(double)>& dphi, double xi) {
    Dense d{std::vector<double>(static_cast<std::size_t>(cells) + 1, 0.0), {}};
    d.grad = d.phi;
    const auto add = [&](int node, double part, double s) {
        d.phi[static_cast<std::size_t>(node)] += part * phi(s);
        d.grad[static_cast<std::size_t>(node)] += part * dphi(s);
    };
    for (int I = -2; I <= cells + 2; ++I) {
        const int out = I < 0 ? -I : I > cells ? I - cells : 0, end = I < 0 ? 0 : cells, inner = I < 0 ? 1 : cells - 1;
        if (out == 0)
            add(I, 1, xi - I);
        else {
            add(end, 1 + out, xi - I);
            add(inner, -out, xi - I);
        }
    }
    return d;
}

/// Equations 3.18 to 3.21: the function of a node by its type.
double cubic_review(int type, double r) {
    if (r < -2 || r > 2) return 0;
    if (r < -1) return type == 2 ? 0 : r * r * r / 6 + r * r + 2 * r + 4.0 / 3;
    if (r > 1) return type == 4 ? 0 : -r * r * r / 6 + r * r - 2 * r + 4.0 / 3;
    if (type == 1) return r < 0 ? -r * r * r / 6 + r + 1 : r * r * r / 6 - r + 1;
    if (r < 0) return (type == 2 ? -1.0 / 3 : -1.0 / 2) * r * r * r - r * r + 2.0 / 3;
    return (type == 4 ? 1.0 / 3 : 1.0 / 2) * r * r * r - r * r + 2.0 / 3;
}

/// Antiderivative of the hat, and the mean of the hat over a domain of length l.
double G(double x) {
    if (x <= -1) return 0;
    if (x >= 1) return 1;
    return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
}
double hat(double x) { return std::max(0.0, 1 - std::abs(x)); }

}  // namespace

TEST(Cubic, IsTheReviewsFourTypes) {
    for (const int cells : {3, 4, 5, 9}) {
        const auto shape = unit_shape<Cubic>(cells);
        for (const double xi : places(cells, 0)) {
            const Dense d = dense(shape, xi);
            for (int I = 0; I <= cells; ++I) {
                const int type = I == 0 || I == cells ? 1 : I == 1 ? 2 : I == cells - 1 ? 4 : 3;
                EXPECT_NEAR(d.phi[static_cast<std::size_t>(I)], cubic_review(type, xi - I), 3e-15) << I << " at " << xi;
            }
        }
    }
}

TEST(Quadratic, IsTheFoldedSpline) {
    const auto phi = [](double s) {
        s = std::abs(s);
        return s < 0.5 ? 0.75 - s * s : s < 1.5 ? (1.5 - s) * (1.5 - s) / 2 : 0;
    };
    const auto dphi = [](double s) {
        const double a = std::abs(s);
        return a < 0.5 ? -2 * s : a < 1.5 ? (s < 0 ? 1 : -1) * (1.5 - a) : 0;
    };
    for (const int cells : {2, 3, 6})
        for (const double xi : places(cells, 0)) expect_same(dense(unit_shape<Quadratic>(cells), xi), folded(cells, phi, dphi, xi), 1e-15, 4e-15);
}

TEST(Gimp, IsTheFoldedMeanOfTheHat) {
    for (const double l : {0.01, 0.3, 0.5, 1.0, 1.2, 1.7, 2.0}) {
        const auto phi = [l](double x) { return (G(x + l / 2) - G(x - l / 2)) / l; };
        const auto dphi = [l](double x) { return (hat(x + l / 2) - hat(x - l / 2)) / l; };
        for (const int cells : {3, 4, 7})
            for (const double xi : places(cells, l)) {
                const Dense reference = folded(cells, phi, dphi, xi);
                expect_same(dense(unit_shape(cells, Cpgimp{l}), xi), reference, 1e-15 / l + 2e-15, 1e-15 / l + 4e-15);
                if (l <= 1) expect_same(dense(unit_shape(cells, Ugimp{l}), xi), reference, 1e-15 / l + 2e-15, 1e-15 / l + 4e-15);
            }
    }
}

/// Equation 3.12 as printed, for l <= h; l <= 1e-4 shows that no digits are lost where the difference of two G loses them.
TEST(Gimp, KeepsItsDigitsForSmallDomains) {
    for (const double l : {1e-2, 1e-4, 1e-8, 1e-12}) {
        const auto phi = [l](double x) {
            x = std::abs(x);
            if (x < l / 2) return 1 - x * x / l - l / 4;
            if (x <= 1 - l / 2) return 1 - x;
            return x < 1 + l / 2 ? (1 - x + l / 2) * ((1 - x + l / 2) / (2 * l)) : 0.0;
        };
        const int cells = 5;
        for (const double s : {0.3, 0.7, l / 4, -l / 4, l / 2, -l / 2, l, -l, 0.0}) {
            const double xi = 2 + s;
            for (const Dense& d : {dense(unit_shape(cells, Cpgimp{l}), xi), dense(unit_shape(cells, Ugimp{l}), xi)}) {
                double slope = 0;
                for (int I = 0; I <= cells; ++I) {
                    EXPECT_NEAR(d.phi[static_cast<std::size_t>(I)], phi(xi - I), 1e-15) << l << ' ' << s << ' ' << I;
                    slope += d.grad[static_cast<std::size_t>(I)] * I;
                }
                EXPECT_NEAR(slope, 1, 2e-15);
                const double kink = std::max(-1.0, std::min(1.0, -2 * (xi - 2) / l));  // the slope of node 2 turns over
                EXPECT_NEAR(d.grad[2], kink, 4e-15);
            }
        }
    }
}

TEST(Gimp, BecomesTheHatForVanishingDomains) {
    const int cells = 6;
    for (const double l : {1e-6, 1e-10, 1e-300})
        for (const double xi : places(cells, 0.4)) {
            const double nearest = std::abs(xi - std::round(xi));
            const Dense reference = dense(unit_shape<Hat>(cells), xi);
            const double gradient = nearest > l / 2 ? 1e-15 : 2;  // at a node the slopes of the two sides are averaged
            expect_same(dense(unit_shape(cells, Ugimp{l}), xi), reference, l / 4 + 1e-15, gradient);
            expect_same(dense(unit_shape(cells, Cpgimp{l}), xi), reference, l / 4 + 1e-15, gradient);
        }
}

TEST(Gimp, OfACellsLengthIsTheQuadraticSpline) {
    for (const int cells : {2, 3, 6})
        for (const double xi : places(cells, 0)) expect_same(dense(unit_shape(cells, Ugimp{1}), xi), dense(unit_shape<Quadratic>(cells), xi), 1e-15, 4e-15);
}

TEST(Gimp, StretchesWithF) {
    Particle<2> p;
    p.F << 1.5, 0.4, 0.4, 0.8;
    EXPECT_DOUBLE_EQ(Cpgimp{0.5}.size(p, 0), 0.75);
    EXPECT_DOUBLE_EQ(Cpgimp{0.5}.size(p, 1), 0.4);
    EXPECT_DOUBLE_EQ(Ugimp{0.5}.size(p, 0), 0.5);
    const Tensor<2, Cpgimp> shape{{Vec<2>::Zero(), Vec<2>::Ones(), {5, 4}, 1}, {0.5}};
    const Vec<2> x(2.2, 1.7);
    const auto along_x = Cpgimp{}(x[0], 5, 0.75), along_y = Cpgimp{}(x[1], 4, 0.4);
    for (std::size_t k = 0; const auto& e : shape.at(x, p)) {
        EXPECT_DOUBLE_EQ(e.phi, along_x.phi[k % 4] * along_y.phi[k / 4]);
        EXPECT_EQ(e.node, along_x.first + static_cast<int>(k % 4) + 6 * (along_y.first + static_cast<int>(k / 4)));
        ++k;
    }
}

TEST(Gimp, RefusesDomainsItDoesNotCover) {
    for (const double l : {0.0, -0.5, 2.0000001, 1e9, std::nan("")}) {
        EXPECT_THROW(Cpgimp{}(2.5, 5, l), DomainTooLong) << l;
        EXPECT_THROW(Ugimp{}(2.5, 5, l), DomainTooLong) << l;
    }
    EXPECT_THROW(Ugimp{}(2.5, 5, 1.01), DomainTooLong);
    EXPECT_NO_THROW(Cpgimp{}(2.5, 5, 2));
    Particle<1> inside_out;
    inside_out.F(0, 0) = -0.1;
    EXPECT_THROW(unit_shape(5, Cpgimp{1}).at(Vec<1>(2), inside_out), OutsideGrid);
    try {
        Cpgimp{}(2.5, 5, 2.25);
    } catch (const DomainTooLong& e) {
        EXPECT_NE(std::string(e.what()).find("2.25"), std::string::npos) << e.what();
    }
}

TEST(Bernstein, IsTheReviewsTwoForms) {
    const int cells = 4;
    const auto shape = unit_shape<Bernstein>(cells);
    for (const double xi : places(cells, 0)) {
        const Dense d = dense(shape, xi);
        for (int I = 0; I <= 2 * cells; ++I) {
            const double r = std::abs(xi - I / 2.0);
            const double phi = I % 2 == 0 ? (r < 1 ? (1 - r) * (1 - r) : 0) : (r < 0.5 ? 0.5 - 2 * r * r : 0);
            EXPECT_NEAR(d.phi[static_cast<std::size_t>(I)], phi, 2e-15);
        }
    }
}

TEST(Lagrange, IsOneAtItsOwnNodeAndZeroAtTheOthers) {
    const int cells = 3;
    const auto shape = unit_shape<Lagrange2>(cells);
    for (int J = 0; J <= 2 * cells; ++J) {
        const Dense d = dense(shape, J / 2.0);
        for (int I = 0; I <= 2 * cells; ++I) EXPECT_EQ(d.phi[static_cast<std::size_t>(I)], I == J ? 1 : 0);
    }
}

TEST(Lagrange, ReproducesQuadraticFunctions) {
    const auto shape = unit_shape<Lagrange2>(4);
    for (const double xi : places(4, 0)) {
        const Dense d = dense(shape, xi);
        double sum = 0, slope = 0;
        for (std::size_t I = 0; I < d.phi.size(); ++I) {
            const double x = static_cast<double>(I) / 2;
            sum += d.phi[I] * x * x;
            slope += d.grad[I] * x * x;
        }
        EXPECT_NEAR(sum, xi * xi, 1e-14);  // three terms of at most 16
        EXPECT_NEAR(slope, 2 * xi, 2e-13);
    }
}

// The slopes of the first element's end: -3, 4, -1 per cell. The lumped mass (the integrals) by Simpson's rule, exact for quadratics.
TEST(Lagrange, HasSlopesAndMassesOfTheQuadraticElement) {
    const AxisWeights<3> low = Lagrange2{}(0, 1), middle = Lagrange2{}(0.5, 1), high = Lagrange2{}(1, 1);
    EXPECT_EQ(low.dphi, (std::array<double, 3>{-3, 4, -1}));
    EXPECT_EQ(middle.dphi, (std::array<double, 3>{-1, 0, 1}));
    EXPECT_EQ(high.dphi, (std::array<double, 3>{1, -4, 3}));
    for (std::size_t I = 0; I < 3; ++I)
        EXPECT_NEAR((low.phi[I] + 4 * middle.phi[I] + high.phi[I]) / 6, I == 1 ? 4.0 / 6 : 1.0 / 6, 1e-16);
}

TEST(Hat, TakesTheInnerBranchAtTheUpperEnd) {
    const Dense d = dense(unit_shape<Hat>(3), 3);
    EXPECT_EQ(d.grad[3], 1);
    EXPECT_EQ(d.grad[2], -1);
}

TEST(Shapes, AreFoundByName) {
    EXPECT_EQ(AllShapes::names(), (std::vector<std::string>{"hat", "ugimp", "cpgimp", "quadratic", "cubic", "bernstein"}));
    for (const std::string& name : AllShapes::names()) {
        int calls = 0;
        EXPECT_TRUE(AllShapes::with(name, [&](auto kernel) {
            ++calls;
            EXPECT_EQ(name, kernel.name);
        }));
        EXPECT_EQ(calls, 1);
        EXPECT_EQ(UpdatedShapes::with(name, [](auto) {}), name != "bernstein");
    }
    EXPECT_EQ(ElementShapes::names(), (std::vector<std::string>{"hat", "lagrange"}));
    EXPECT_FALSE(AllShapes::with("hats", [](auto) { FAIL(); }));
    EXPECT_FALSE(AllShapes::with("", [](auto) { FAIL(); }));
}

TEST(Stored, KeepsTheWeightsOfTheStart) {
    for (const std::string& name : AllShapes::names())
        AllShapes::with(name, [](auto kernel) {
            using Kernel = decltype(kernel);
            const auto shape = unit_shape<Kernel>(5);
            std::vector<Particle<1>> points(3);
            for (std::size_t i = 0; i < 3; ++i) points[i].X[0] = 0.7 + 1.3 * static_cast<double>(i);
            const Stored<Tensor<1, Kernel>> stored(shape, points);
            const auto now = shape.at(points[1].X, points[1]);
            points[1].x[0] = 4;
            points[1].F(0, 0) = 1.4;
            for (std::size_t k = 0; k < now.size(); ++k) EXPECT_EQ(stored(points[1], 1)[k].phi, now[k].phi);
        });
}

}  // namespace mpm::test
