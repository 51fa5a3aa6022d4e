#include "chapters/implicit/program.hpp"

namespace mpm {

void NewtonFile::write(const std::vector<SolvedStep>& history) {
    if (path_.empty()) return;
    static const std::vector<std::string> columns{"solution", "t", "dt", "iteration", "residual", "terms", "part", "converged"};
    if (!file_) file_ = std::make_unique<CsvFile>(path_, columns);
    for (; written_ < history.size(); ++written_) {
        const SolvedStep& step = history[written_];
        for (std::size_t i = 0; i < step.newton.history.size(); ++i) {
            const NewtonRecord& r = step.newton.history[i];
            const double row[] = {static_cast<double>(written_), step.t, step.dt, static_cast<double>(i), r.residual, r.terms, r.part,
                                  step.newton.converged ? 1.0 : 0.0};
            file_->row(row, std::size(row));
        }
    }
}

void add_facts(const ImplicitCounts& counts, std::vector<std::pair<std::string, double>>& facts) {
    const auto number = [](long n) { return static_cast<double>(n); };
    facts.emplace_back("unknowns, at most", counts.unknowns);
    facts.emplace_back("non-zeros of the tangent", number(counts.nonzeros));
    facts.emplace_back("Newton iterations per step", number(counts.iterations) / number(std::max(1L, counts.solutions)));
    facts.emplace_back("the same, at most", counts.most_iterations);
    facts.emplace_back("steps cut", number(counts.cuts));
    facts.emplace_back("symbolic factorisations", number(counts.analyses));
    facts.emplace_back("numerical factorisations", number(counts.factorisations));
    facts.emplace_back("assembly, CPU s", counts.assembly.cpu);
    facts.emplace_back("solution, CPU s", counts.solution.cpu);
    if (counts.soft_work != 0) facts.emplace_back("work of the soft stiffness", counts.soft_work);
}

void ImplicitOptions::declare(Options& o, bool plane) {
    o.number("beta", beta, "-", {.low = 0, .high = 1, .low_open = true}, "of Newmark's rule");
    o.number("gamma", gamma, "-", between(0, 1), "of Newmark's rule; more than 1/2 damps");
    o.choice("carry", carry, carry_names(),
             "what particles carry: Newmark's acceleration or that of the grid, or the midpoint rule, which needs none; conserving: "
             "with the stress that keeps the energy");
    o.choice("tangent", tangent, {"analytic", "ad"}, "by hand, or by automatic differentiation of the residual");
    o.number("tolerance", tolerance, "-", between(1e-14, 1e-2), "of Newton's residual over the size of its terms");
    o.integer("iterations", iterations, "-", between(1, 1000), "Newton iterations of a step, at most");
    o.integer("cuts", cuts, "-", between(0, 30), "halvings of a step that cannot be solved, at most");
    o.choice("inactive", inactive, {"left-out", "solved"},
             "nodes without particles: left out of the system, or solved for with lumped masses");
    o.flag("newton", newton, "write newton.csv: every iteration");
    o.unlabelled("newton");
    if (!plane) return;
    o.number("soft-few", soft_few, "-", between(0, 1), "soft stiffness C_E of elements less than half of whose nodes count (flag M_E)");
    o.number("soft-some", soft_some, "-", between(0, 1), "the same of other elements at the border");
    o.number("receding", receding, "-", between(0, 1), "C_c, correction of the receding contact; 0: none");
}

std::string newton_path(const std::string& program, const Options& options, const Common& common, int cells,
                        const ImplicitOptions& method) {
    if (!method.newton) return "";
    const std::string folder = run_folder(program, options, common.out, common.label);
    return folder + (common.cells.size() > 1 ? "/cells-" + std::to_string(cells) : "") + "/newton.csv";
}

ImplicitSettings ImplicitOptions::settings(const Options& o, int threads) const {
    ImplicitSettings s;
    s.carry = carry_of(carry);
    if (by_midpoint(s.carry) && (o.given("beta") || o.given("gamma")))
        throw BadInput("--carry " + carry + ": has no --beta and --gamma, it is the midpoint rule");
    s.newmark = by_midpoint(s.carry) ? Newmark::midpoint() : Newmark{beta, gamma, 1};
    s.newton.tolerance = tolerance;
    s.newton.iterations = iterations;
    s.soft = {soft_few, soft_some};
    s.receding.C_c = receding;
    if (s.carry == Carry::conserving && o.given("tangent") && tangent != "ad")
        throw BadInput("--tangent analytic: --carry conserving has its tangent by automatic differentiation, ad");
    s.automatic = tangent == "ad" || s.carry == Carry::conserving;
    s.solve_inactive = inactive == "solved";
    s.cuts = cuts;
    s.threads = threads;
    return s;
}

}  // namespace mpm
