// Turns the forms of a plan into the nodes of its tree.
#pragma once

#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// Used once. Keeps its own stack, so that no depth of a plan is too great.
class PlanTreeBuilder {
public:
    PlanTreeBuilder(PlanTree& tree, const posh::Plan& plan, PlanSharing sharing);
    void build();

private:
    struct Reference {
        const posh::Call* call;
        std::string segment; ///< "/A:2"
    };
    struct Member {
        std::variant<const posh::Drive*, const posh::Element*> part;
        int level;
        bool has_equals;
        int number;
    };
    struct SenseStep {
        const posh::SenseTest* test;
        int number;
    };
    struct Root {
        std::size_t form; ///< of the plan
    };
    struct Close {
        std::size_t form;
    };
    struct Task {
        int parent;
        std::variant<Reference, Member, SenseStep, Root, Close> what;
    };

    void indexForms();
    std::vector<std::size_t> unreachedForms() const;
    void markReachable(std::size_t form, std::vector<bool>& reached) const;
    void run(const Task& task);
    void addReference(int parent, const Reference& reference);
    void addMember(int parent, const Member& member);
    void addSenseStep(int parent, const SenseStep& step);
    void addForm(int parent, std::size_t form, const std::string& before);
    void openForm(int node, std::size_t form);
    void addSenses(int parent, const posh::Senses& senses, bool of_goal);
    int add(PlanNode node);
    void later(int parent, decltype(Task::what) what) { coming_.push_back({parent, std::move(what)}); }
    void pushComing();
    void finish();

    PlanTree& tree_;
    const posh::Plan& plan_;
    PlanSharing sharing_;
    std::unordered_map<std::string, std::size_t> form_of_name_;
    std::vector<int> number_of_form_; ///< among those of its kind
    std::vector<int> drawn_at_;       ///< by form
    std::vector<int> open_at_;        ///< by form: the node we are in, or -1
    std::vector<std::uint64_t> path_hash_;
    std::vector<Task> stack_;
    std::vector<Task> coming_; ///< what the running task asked for, in its order
    std::unordered_map<std::uint64_t, int> seen_keys_;
};

} // namespace usar::widgets
