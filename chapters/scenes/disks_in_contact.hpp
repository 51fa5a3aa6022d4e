/// The two disks of review 6.1.2 as bodies with fields of their own, or in one field whose nodes make the contact (review 5.1).
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/scenes/two_disks.hpp"
#include "lab/contact_log.hpp"

namespace mpm {

struct DisksInContact : TwoDisks<false> {
    static constexpr const char* name = "disks-in-contact";
    static constexpr std::array<const char*, 5> columns{"approach", "approach_exact", "speed", "gap", "friction"};

    std::string field = "own", placing = "rings";
    double impact = 0;  // distance of the disks' paths over their radius [-]
    std::shared_ptr<ContactLog<2>> log = std::make_shared<ContactLog<2>>();

    void declare(Options& o) {
        DiskSettings::declare(o);
        o.choice("field", field, {"own", "shared"}, "each disk has a velocity field of its own, or both share one, which sticks");
        o.choice("placing", placing, {"rings", "cells"}, "particles of the disks: in rings about their centres, or those of cells");
        o.number("impact", impact, "-", between(0, 0.9), "distance of the paths of their centres over the radius; 0: head on");
    }
    /// Sideways shift of the upper disk.
    Vec<2> shift() const { return impact * radius * Vec<2>(1, -1) / std::numbers::sqrt2; }
    /// Centres close in along the diagonal until they are two radii apart.
    double touches() const {
        const double along = 2 * radius * std::sqrt(1 - 0.25 * impact * impact);
        return (0.6 * std::numbers::sqrt2 - along) / (2 * std::numbers::sqrt2 * v0);
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        std::vector<Point> lower = placing == "cells" ? lower_disk<Point>(cells, ppc)
                                                      : rings<Point>(Vec<2>(0.2, 0.2), radius, 1.0 / cells / ppc, rho);
        for (Point& p : lower) p.v = Vec<2>(v0, v0);
        std::vector<Point> upper = lower;
        for (Point& p : upper) {
            p.X = p.x = Vec<2>::Constant(1 + 2 * (placing == "cells" ? offset / cells : 0)) - p.x + shift();
            p.v = -p.v;
        }
        if (field == "own") return {lower, upper};
        lower.insert(lower.end(), upper.begin(), upper.end());
        return {lower};
    }

    struct State {
        double approach = 0, speed = 0, gap = 0;  // of the centres; the lower disk's along the diagonal; of the faces
    };
    template <class Points> State state(const Points& points) const {
        const std::size_t half = points.size() / 2;
        Vec<2> apart = Vec<2>::Zero(), v = apart;
        std::size_t i = 0;
        for (const auto& p : points) {
            apart += i < half ? -p.x : p.x;
            if (i++ < half) v += p.v;
        }
        apart /= static_cast<double>(half), v /= static_cast<double>(half);
        return {apart.norm(), v.sum() / std::numbers::sqrt2, apart.norm() - 2 * radius};
    }
    template <class Points> std::array<double, 5> watch(const Points& points, double t) const {
        const State now = state(points);
        const double along = 0.6 * std::numbers::sqrt2 - 2 * std::numbers::sqrt2 * v0 * t;
        const double exact = t < touches() ? std::hypot(along, impact * radius) : std::numeric_limits<double>::quiet_NaN();
        return {now.approach, exact, now.speed, now.gap, log->friction};
    }

    /// When the disks feel each other: at the first impulse of contact; in one field when the kinetic energy has fallen by 0.1 %.
    struct Observer {
        const DisksInContact& scene;
        double first = 0, felt = std::numeric_limits<double>::quiet_NaN(), energy = 0;
        State end{};

        template <class Points> void sample(const Points& points, double t, double now) {
            double kinetic = 0;
            for (const auto& p : points) kinetic += 0.5 * p.m * p.v.squaredNorm();
            if (t == 0) first = kinetic;
            if (std::isnan(felt) && kinetic < 0.999 * first) felt = t;
            if (!std::isnan(now)) energy = now, end = scene.state(points);
        }
        bool wants_energy(double t, double t_end) const { return t >= t_end; }
        double touched() const { return scene.field == "own" ? scene.log->touched : felt; }
        std::vector<NamedError> errors(double) const {
            const double closing = 2 * std::numbers::sqrt2 * scene.v0;
            return {{"touch", std::abs(touched() - scene.touches()) * closing}, {"energy", std::abs(energy / first - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"disks touch at", touched()},
                    {"exact", scene.touches()},
                    {"kinetic energy fallen by 0.1 % at", felt},
                    {"disks part at", scene.log->parted},
                    {"rebound speed over the first", -end.speed / (std::numbers::sqrt2 * scene.v0)},
                    {"energy that friction took / first", scene.log->friction / first},
                    {"energy that normal impulses took / first", scene.log->normal / first}};
        }
    };
};

}  // namespace mpm
