/// A law that is chosen when the program runs, for `--law`: a step is then compiled once for all of them.
#pragma once
#include <string>
#include <variant>

namespace mpm {

namespace detail {
template <class Law, class Point> concept TellsAcross = requires(const Law& law, const Point& p) { law.sigma_zz(p); };
}

/// One of several laws without history. Every particle takes the same branch, which the processor foresees; a program that has one law
/// names it as a type.
template <class... Laws> class OneOf {
public:
    static constexpr const char* name = "one-of";
    OneOf() = default;
    /// The law of that name; the first one if there is none.
    OneOf(const std::string& law, double lambda, double mu, double rho) {
        static_cast<void>(((law == Laws::name && (chosen_ = Laws{lambda, mu, rho}, true)) || ...));
    }

    double wave_speed() const {
        return std::visit([](const auto& law) { return law.wave_speed(); }, chosen_);
    }
    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        std::visit([&](const auto& law) { law.update(p, L, dt); }, chosen_);
    }
    template <class Point> double energy(const Point& p) const {
        return std::visit([&](const auto& law) { return law.energy(p); }, chosen_);
    }
    template <class Point>
        requires(detail::TellsAcross<Laws, Point> && ...)
    double sigma_zz(const Point& p) const {
        return std::visit([&](const auto& law) { return law.sigma_zz(p); }, chosen_);
    }

private:
    std::variant<Laws...> chosen_;
};

}  // namespace mpm
