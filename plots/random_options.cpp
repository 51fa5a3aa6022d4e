#include "plots/random_options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "lab/record.hpp"

namespace mpm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool chance(Random& random, double p) { return std::bernoulli_distribution(p)(random); }
double uniform(Random& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
std::size_t place(Random& random, std::size_t size) { return std::uniform_int_distribution<std::size_t>(0, size - 1)(random); }

/// Mostly near the default, sometimes far from it, and now and then an end of the range.
double random_number(const DescribedOption& o, Random& random) {
    const bool low = std::isfinite(o.low), high = std::isfinite(o.high);
    if (low && chance(random, 0.05)) return o.low;
    if (high && chance(random, 0.05)) return o.high;
    const double initial = std::atof(o.initial.c_str());
    double x = (low && high && o.high - o.low < 1e3) ? uniform(random, o.low, o.high)
               : initial != 0                        ? initial * std::pow(10, uniform(random, -1, 1) * (chance(random, 0.1) ? 9 : 0.5))
                                                     : std::pow(10, uniform(random, -6, 1));
    if (!low && chance(random, 0.2)) x = -x;
    return std::clamp(x, o.low, o.high);
}

std::string random_value(const DescribedOption& o, Random& random) {
    if (o.type == "choice") return o.choices[place(random, o.choices.size())];
    if (o.type == "integer" || o.type == "integers") {
        const double x = std::round(random_number(o, random));
        return std::to_string(static_cast<long>(std::clamp(x, o.low, std::min(o.high, 1e15))));
    }
    return number_text(random_number(o, random));
}

bool is_left_out(const std::string& name) {
    static const Words names{"out",     "label",    "config",  "plot",   "quiet",  "dry-run", "help",
                             "version", "describe", "records", "frames", "repeat", "threads", "format"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

Words one_wrong(const DescribedOption& o, Random& random) {
    const std::string name = "--" + o.name;
    switch (place(random, 4)) {
        case 0:
            return {name + "x", "1"};
        case 1:
            return {"stray"};
        case 2:
            return o.type == "flag" ? Words{name + "=perhaps"} : Words{name};
        default:
            break;
    }
    const bool whole = o.type == "integer" || o.type == "integers";
    if (o.type == "choice") return {name, "no-such-choice"};
    if (o.type == "flag") return {name + "=2.5"};
    if (o.type == "text") return {"--no-" + o.name};
    Words values{"nan", "inf", "abc", "1e", "", "1;2", "0x10"};
    if (whole) values.push_back("1.5");
    if (std::isfinite(o.low))
        values.push_back(whole ? std::to_string(static_cast<long>(o.low) - 1) : number_text(o.low - 1 - std::abs(o.low)));
    if (std::isfinite(o.high) && o.high < 1e15)
        values.push_back(whole ? std::to_string(static_cast<long>(o.high) + 1) : number_text(2 * o.high + 1));
    return {name, values[place(random, values.size())]};
}

}  // namespace

std::vector<DescribedOption> described_options(const CsvTable& described) {
    std::vector<DescribedOption> options;
    for (std::size_t i = 0; i < described.rows.size(); ++i) {
        DescribedOption o{described.text(i, "name"),  described.text(i, "type"),   described.text(i, "default"),
                          described.number(i, "low"), described.number(i, "high"), {}};
        if (std::isnan(o.low)) o.low = -infinity;
        if (std::isnan(o.high)) o.high = infinity;
        std::istringstream choices(described.text(i, "choices"));
        for (std::string choice; std::getline(choices, choice, '|');) o.choices.push_back(choice);
        options.push_back(std::move(o));
    }
    return options;
}

Words random_settings(const std::vector<DescribedOption>& options, Random& random) {
    Words words;
    for (const DescribedOption& o : options) {
        if (is_left_out(o.name) || o.type == "text" || !chance(random, 0.33)) continue;
        if (o.type == "flag")
            words.push_back("--" + o.name);
        else
            words.push_back("--" + o.name + "=" + random_value(o, random));
    }
    return words;
}

Words wrong_settings(const std::vector<DescribedOption>& options, Random& random) {
    std::vector<DescribedOption> own;
    for (const DescribedOption& o : options)
        if (!is_left_out(o.name)) own.push_back(o);
    if (own.empty()) return {"--no-such-option"};
    Words words = one_wrong(own[place(random, own.size())], random);
    return words;
}

}  // namespace mpm
