/// What review 3.1 asks of a weighting function, for every member of the family.
#include "tests/chapters/weighting/family.hpp"

namespace mpm::test {

template <class M> struct Weighting : ::testing::Test {
    using Kernel = typename M::Kernel;

    /// check(shape, xi, x) on every line and at every place.
    template <class Check> static void everywhere(Check&& check) {
        for (const Lattice<1>& lattice : lines(Kernel::min_cells)) {
            const auto shape = shape_on<M, 1>(lattice);
            for (const double xi : places(lattice.cells(0), M::l)) {
                const double x = lattice.origin()[0] + xi * lattice.h()[0];
                if (!lattice.holds(x, 0)) continue;  // rounded to the outside
                SCOPED_TRACE(std::to_string(xi) + " of " + std::to_string(lattice.cells(0)) + " cells of " +
                             number(lattice.h()[0]) + " from " + number(lattice.origin()[0]));
                check(shape, xi, x);
                if (::testing::Test::HasFailure()) return;
            }
        }
    }
    static std::string number(double x) {
        char text[32];
        std::snprintf(text, sizeof text, "%g", x);
        return text;
    }
};
TYPED_TEST_SUITE(Weighting, Members);

TYPED_TEST(Weighting, SumsToOne) {
    this->everywhere([](const auto& shape, double, double x) {
        double sum = 0;
        for (const double phi : dense(shape, x).phi) sum += phi;
        EXPECT_NEAR(sum, 1, 1e-15 * 4);
    });
}

TYPED_TEST(Weighting, GradientsSumToZero) {
    this->everywhere([](const auto& shape, double, double x) {
        double sum = 0;
        for (const double g : dense(shape, x).grad) sum += g;
        EXPECT_NEAR(sum * shape.lattice.h()[0], 0, 1e-15 * 8);
    });
}

TYPED_TEST(Weighting, IsNowhereNegativeOrAsStated) {
    this->everywhere([](const auto& shape, double, double x) {
        for (const double phi : dense(shape, x).phi) EXPECT_GE(phi, least_weight<typename TypeParam::Kernel>);
    });
}

TYPED_TEST(Weighting, ReproducesLinearFunctions) {
    this->everywhere([](const auto& shape, double, double x) {
        const auto& lattice = shape.lattice;
        const Dense d = dense(shape, x);
        double sum = 0, slope = 0;
        for (int I = 0; I < lattice.size(); ++I) {
            sum += d.phi[static_cast<std::size_t>(I)] * lattice.position(I)[0];
            slope += d.grad[static_cast<std::size_t>(I)] * lattice.h()[0] / lattice.per_cell() * I;  // from the lower corner
        }
        EXPECT_NEAR(sum, x, 2e-15 * (std::abs(lattice.origin()[0]) + lattice.h()[0] * lattice.cells(0)));
        EXPECT_NEAR(slope, 1, 2e-14);
    });
}

TYPED_TEST(Weighting, GradientIsTheCentralDifference) {
    this->everywhere([](const auto& shape, double xi, double) {
        const double step = 1e-5, h = shape.lattice.h()[0];
        const int cells = shape.lattice.cells(0);
        if (h < 1e-2 && std::abs(shape.lattice.origin()[0]) > 1) return;  // places too coarse for a difference
        if (std::abs(shape.lattice.origin()[0]) > 1e6 * h) return;
        for (const double joint : joints(cells, TypeParam::l))
            if (std::abs(xi - joint) < 1.1 * step) return;
        const double x = shape.lattice.origin()[0] + xi * h;
        const Dense below = dense(shape, x - step * h), here = dense(shape, x), above = dense(shape, x + step * h);
        for (std::size_t I = 0; I < here.phi.size(); ++I)
            EXPECT_NEAR(here.grad[I] * h, (above.phi[I] - below.phi[I]) / (2 * step), 1e-9);
    });
}

TYPED_TEST(Weighting, IsKroneckerAtTheGridEnds) {
    for (const Lattice<1>& lattice : lines(TypeParam::Kernel::min_cells)) {
        const auto shape = shape_on<TypeParam, 1>(lattice);
        const double rounding = std::abs(lattice.cells(0) - lattice.in_cells(lattice.upper()[0], 0));  // of the upper end, in cells
        if (rounding < 0) continue;  // counts as outside
        const Dense low = dense(shape, lattice.origin()[0]), high = dense(shape, lattice.upper()[0]);
        const std::size_t last = low.phi.size() - 1;
        for (std::size_t I = 0; I <= last; ++I) {
            EXPECT_EQ(low.phi[I], I == 0 ? 1 : 0);
            EXPECT_NEAR(high.phi[I], I == last ? 1 : 0, 1.01 * steepest<typename TypeParam::Kernel> * rounding);  // exact where the end is
        }
        if (lagrange<typename TypeParam::Kernel>) continue;  // three functions have a slope there: kernels_test.cpp
        const double slope = shape.lattice.per_cell() / lattice.h()[0], near = 1e-14 + 2.01 * rounding;
        EXPECT_NEAR(low.grad[0] / slope, -1, 1e-14);
        EXPECT_NEAR(low.grad[1] / slope, 1, 1e-14);
        EXPECT_NEAR(high.grad[last] / slope, 1, near);
        EXPECT_NEAR(high.grad[last - 1] / slope, -1, near);
    }
}

/// C^order across every joint inside the grid, and no smoother: the next derivative does jump somewhere.
TYPED_TEST(Weighting, IsAsSmoothAsStated) {
    const double s = 1e-7;
    const int cells = 7;
    const auto shape = shape_on<TypeParam, 1>(line(0, 1, cells));
    double jump0 = 0, jump1 = 0, jump2 = 0, jump3 = 0;
    for (const double at : joints(cells, TypeParam::l)) {
        if (at < 0.01 || at > cells - 0.01) continue;
        const Dense a = dense(shape, at - s), b = dense(shape, at + s);
        const Dense A = dense(shape, at - 1e-3), B = dense(shape, at + 1e-3), AA = dense(shape, at - 2e-3), BB = dense(shape, at + 2e-3);
        for (std::size_t I = 0; I < a.phi.size(); ++I) {
            const auto larger = [](double& m, double x) { m = std::max(m, std::abs(x)); };
            larger(jump0, b.phi[I] - a.phi[I]);
            larger(jump1, b.grad[I] - a.grad[I]);
            larger(jump2, (B.grad[I] - b.grad[I] - a.grad[I] + A.grad[I]) / (1e-3 - s));
            larger(jump3, ((BB.grad[I] - 2 * B.grad[I] + b.grad[I]) - (a.grad[I] - 2 * A.grad[I] + AA.grad[I])) / 1e-6);
        }
    }
    const int order = TypeParam::order;
    EXPECT_LT(jump0, 1e-6);
    if (order == 0) { EXPECT_GT(jump1, 0.9); }
    if (order >= 1) { EXPECT_LT(jump1, 1e-5); }
    if (order == 1) { EXPECT_GT(jump2, 0.4); }
    if (order >= 2) { EXPECT_LT(jump2, 1e-2); }
    if (order == 2) { EXPECT_GT(jump3, 0.9); }
}

TYPED_TEST(Weighting, HoldsInTwoDimensions) {
    constexpr int least = TypeParam::Kernel::min_cells;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    for (const double scale : {1.0, 1e-9, 1e9}) {
        const Lattice<2> lattice{Vec<2>(-2 * scale, scale), Vec<2>(0.5 * scale, 2 * scale), {least + 2, least}, 1};
        const auto shape = shape_on<TypeParam, 2>(lattice);
        const Vec<2> size(lattice.h()[0] * lattice.cells(0), lattice.h()[1] * lattice.cells(1));
        Particle<2> p;
        p.F << 0.7, 0.3, -0.2, 0.9;
        for (int trial = 0; trial < 1000; ++trial) {
            p.x = lattice.origin() + size.cwiseProduct(Vec<2>(part(random), part(random)));
            if (trial < 9) p.x = lattice.origin() + size.cwiseProduct(Vec<2>(trial % 3 / 2.0, trial / 3 / 2.0) * (1 - 1e-14));  // at the upper end rounding may lie outside
            bool outside = false;  // an upper end may round to a hair outside
            for (int d = 0; d < 2; ++d) outside = outside || !lattice.holds(p.x[d], d);
            if (outside) continue;
            double sum = 0;
            Vec<2> gradients = Vec<2>::Zero(), x = Vec<2>::Zero();
            Mat<2> slope = Mat<2>::Zero();
            for (const auto& e : shape(p, 0)) {
                ASSERT_GE(e.node, 0);
                ASSERT_LT(e.node, shape.lattice.size());
                EXPECT_GE(e.phi, least_weight<typename TypeParam::Kernel>);
                sum += e.phi;
                gradients += e.grad;
                x += e.phi * shape.lattice.position(e.node);
                slope += (shape.lattice.position(e.node) - p.x) * e.grad.transpose();
            }
            EXPECT_NEAR(sum, 1, 1e-14);
            EXPECT_LT(gradients.norm() * scale, 1e-13);
            EXPECT_LT((x - p.x).norm(), 1e-13 * scale);
            EXPECT_LT((slope - identity<2>()).norm(), 1e-12);
            if (trial < 9) continue;  // the rest: gradients against differences, away from the joints
            const double step = 1e-6;
            for (int d = 0; d < 2; ++d) {
                const double xi = lattice.in_cells(p.x[d], d), l = TypeParam::l * p.F(d, d);
                bool near = false;
                for (const double length : {l, TypeParam::l})
                    for (const double joint : joints(lattice.cells(d), length))
                        near = near || std::abs(xi - joint) < 2 * step;
                if (near) continue;
                Particle<2> low = p, high = p;
                low.x[d] -= step * lattice.h()[d];
                high.x[d] += step * lattice.h()[d];
                std::vector<double> difference(static_cast<std::size_t>(shape.lattice.size()), 0.0);
                for (const auto& e : shape(high, 0)) difference[static_cast<std::size_t>(e.node)] += e.phi;
                for (const auto& e : shape(low, 0)) difference[static_cast<std::size_t>(e.node)] -= e.phi;
                for (const auto& e : shape(p, 0)) difference[static_cast<std::size_t>(e.node)] -= 2 * step * lattice.h()[d] * e.grad[d];
                for (const double rest : difference) EXPECT_NEAR(rest / step, 0, 1e-8);
            }
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TYPED_TEST(Weighting, RefusesWhatIsOutside) {
    const auto shape = shape_on<TypeParam, 1>(line(-1, 0.5, 4));
    const double inf = std::numeric_limits<double>::infinity();
    for (const double x : {std::nextafter(-1.0, -2.0), std::nextafter(1.0, 2.0) + 1e-15, -7.0, 1e300, -1e300, inf, -inf, std::nan("")})
        EXPECT_THROW(shape.at(Vec<1>(x), Particle<1>{}), OutsideGrid) << x;
    EXPECT_NO_THROW(shape.at(Vec<1>(-1), Particle<1>{}));
    EXPECT_NO_THROW(shape.at(Vec<1>(1), Particle<1>{}));
    const auto plane = shape_on<TypeParam, 2>({Vec<2>::Zero(), Vec<2>::Ones(), {4, 4}, 1});
    EXPECT_THROW(plane.at(Vec<2>(2, 4.1), Particle<2>{}), OutsideGrid);
    EXPECT_THROW(plane.at(Vec<2>(std::nan(""), 2), Particle<2>{}), OutsideGrid);
}

/// A grid with too few cells never gives a node that is not there.
TYPED_TEST(Weighting, RefusesTooFewCells) {
    for (int cells = 1; cells < TypeParam::Kernel::min_cells; ++cells)
        for (const double xi : places(cells, TypeParam::l))
            EXPECT_THROW((shape_on<TypeParam, 1>(line(0, 1, cells)).at(Vec<1>(xi), Particle<1>{})), OutsideGrid) << xi;
}

}  // namespace mpm::test
