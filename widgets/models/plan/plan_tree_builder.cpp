// Builds the tree of a plan from its forms.
#include "widgets/models/plan/plan_tree.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <numeric>

#include <QObject>

#include "core/posh/language/plan_text.h"
#include "core/posh/model/plan_walk.h"

namespace usar::widgets {

namespace {

using namespace usar::posh;

QString spelled(const Literal& literal) {
    std::string text;
    appendLiteral(text, literal);
    return QString::fromUtf8(text);
}

QString textOf(const Call& call) {
    std::string text;
    appendCall(text, call);
    return QString::fromUtf8(text);
}

/// Returns the text of a call after the name of the form.
QString argumentsOf(const Call& call) {
    return textOf(call).mid(QString::fromUtf8(call.name.text).size());
}

QString comparison(const SenseTest& test) {
    if (!test.operand)
        return {};
    const QString sign = test.predicate ? QString::fromUtf8(toText(*test.predicate)) : QStringLiteral("==");
    return (sign == u"==" ? QStringLiteral("=") : sign) + u' ' + spelled(*test.operand);
}

/// Returns "2 s" or "0.5 Hz"; empty for an interval that limits nothing.
QString amountText(const std::optional<Interval>& interval) {
    constexpr std::array units{"h", "min", "s", "ms", "Hz", "a minute", "cycles"}; // In the order of Unit.
    if (!interval || (interval->unit == Unit::None && numberOf(interval->amount.value) <= 0.0))
        return {};
    return spelled(interval->amount) + u' ' + QObject::tr(units[static_cast<std::size_t>(interval->unit)]);
}

/// These return the rest of the line of a drive, an element or a form, after its name; empty if there is none.
QString driveDetail(const std::optional<Interval>& frequency) {
    const QString amount = amountText(frequency);
    if (amount.isEmpty())
        return {};
    const bool is_rate = frequency->unit == Unit::Hz || frequency->unit == Unit::PerMinute;
    return (is_rate ? QObject::tr("at most %1") : QObject::tr("every %1")).arg(amount);
}

QString elementDetail(const posh::Member& element) {
    const auto limit = retryLimit(element);
    return !limit        ? QString()
           : *limit == 1 ? QObject::tr("at most 1 start")
                         : QObject::tr("at most %1 starts").arg(*limit);
}

template <class AnyForm>
QString detailOf(const AnyForm& form) {
    QString limit;
    if constexpr (requires { form.time_limit; })
        limit = amountText(form.time_limit);
    return limit.isEmpty() ? limit : QObject::tr("%1 at most").arg(limit);
}

QString joined(const QString& first, const QString& second) {
    return first.isEmpty() || second.isEmpty() ? first + second : first + QStringLiteral(" · ") + second;
}

QString textOf(const std::optional<Literal>& comment) {
    const auto* const text = comment ? std::get_if<std::string>(&comment->value) : nullptr;
    return text ? QString::fromStdString(*text) : QString();
}

/// Returns an empty text also for parts that have no comments.
template <class Part>
QString commentOf(const Part& part) {
    if constexpr (requires { part.comment; })
        return textOf(part.comment);
    else
        return {};
}

} // namespace

/// For a single use. Works with its own stack, so the depth of a plan is not limited.
class PlanTreeBuilder {
public:
    PlanTreeBuilder(PlanTree& tree, const Plan& plan, PlanSharing sharing)
        : tree_(tree)
        , plan_(plan)
        , sharing_(sharing)
        , drawn_at_(plan.forms.size())
        , open_at_(plan.forms.size()) {
        std::array<int, 4> count{};
        for (std::size_t i = 0; i < plan.forms.size(); ++i) {
            number_of_form_.push_back(count[plan.forms[i].index()]++);
            if (!isCollection(i))
                form_of_name_.emplace(nameOf(plan.forms[i]).text, i);
        }
    }

    /// Fills the tree.
    void build() {
        if (plan_.forms.empty())
            return;
        std::vector<std::size_t> roots = unreachedForms();
        const PlanNodeId parent = roots.empty() ? PlanNodeId{} : addPlan();
        for (std::size_t i = 0; i < plan_.forms.size(); ++i)
            if (isCollection(i))
                roots.insert(roots.begin(), i);
        for (const std::size_t root : roots)
            later([=, this] { addForm(parent, root, parent.valid() ? "" : "/P:0"); });
        for (pushComing(); !stack_.empty(); pushComing()) {
            const auto task = std::move(stack_.back());
            stack_.pop_back();
            task();
        }
        finish();
    }

private:
    bool isCollection(std::size_t form) const { return std::holds_alternative<Collection>(plan_.forms[form]); }
    PlanNode& nodeAt(PlanNodeId node) { return tree_.nodes_[node.index()]; }

    /// Returns the indices of the forms that a form calls.
    std::vector<std::size_t> formsCalledBy(std::size_t form) const {
        std::vector<std::size_t> called;
        forEachCall(plan_.forms[form], [&](const Call& call, bool is_sense) {
            if (const auto known = form_of_name_.find(call.name.text); !is_sense && known != form_of_name_.end())
                called.push_back(known->second);
        });
        return called;
    }

    /// Returns the forms that no collection leads to, without their descendants: first those that no form names, then
    /// one form of each circle that only names itself.
    std::vector<std::size_t> unreachedForms() const {
        std::vector<bool> reached(plan_.forms.size(), false);
        std::vector<bool> named(plan_.forms.size(), false);
        for (std::size_t i = 0; i < plan_.forms.size(); ++i) {
            if (isCollection(i))
                markReachable(i, reached);
            for (const std::size_t called : formsCalledBy(i))
                named[called] = true;
        }
        std::vector<std::size_t> roots;
        for (const bool only_unnamed : {true, false})
            for (std::size_t i = 0; i < plan_.forms.size(); ++i)
                if (!reached[i] && !(only_unnamed && named[i])) {
                    roots.push_back(i);
                    markReachable(i, reached);
                }
        return roots;
    }

    /// Marks this form and every form that it leads to.
    void markReachable(std::size_t form, std::vector<bool>& reached) const {
        std::vector<std::size_t> open{form};
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            if (!reached[at])
                std::ranges::copy(formsCalledBy(at), std::back_inserter(open));
            reached[at] = true;
        }
    }

    /// Schedules a task; tasks run depth-first in the order in which they were scheduled.
    void later(std::function<void()> task) { coming_.push_back(std::move(task)); }

    /// Moves the scheduled tasks to the stack, so that they run before older ones.
    void pushComing() {
        std::move(coming_.rbegin(), coming_.rend(), std::back_inserter(stack_));
        coming_.clear();
    }

    /// Appends a node and sets its depth, key and path; returns its id.
    PlanNodeId add(PlanNode node) {
        const bool is_root = !node.parent.valid();
        const std::size_t parent = node.parent.index();
        node.depth = is_root ? 0 : tree_.nodes_[parent].depth + 1;
        const std::uint64_t name_key =
            planHash(is_root ? plan_hash_start : tree_.nodes_[parent].key, "/" + node.name.toStdString());
        const int namesakes = seen_keys_[name_key]++;
        node.key = namesakes == 0 ? name_key : planHash(name_key, "#" + std::to_string(namesakes));
        path_hash_.push_back(planHash(is_root ? plan_hash_start : path_hash_[parent], node.segment));
        const PlanNodeId id{tree_.size()};
        tree_.by_path_.emplace(path_hash_.back(), id);
        tree_.nodes_.push_back(std::move(node));
        return id;
    }

    /// Adds the common root of several forms.
    PlanNodeId addPlan() {
        return add(
            {.segment = "/P:0",
             .name = plan_.documentation ? textOf(plan_.documentation->title) : QObject::tr("Plan"),
             .detail = collectionOf(plan_) ? QObject::tr("with unused parts") : QObject::tr("no drive collection")});
    }

    /// Adds what a call leads to: a form with the arguments of the call, or an act.
    void addCall(PlanNodeId parent, const Call& call, const std::string& segment) {
        const auto known = form_of_name_.find(call.name.text);
        if (known == form_of_name_.end()) {
            add({.kind = PlanNodeKind::Act,
                 .parent = parent,
                 .segment = segment,
                 .name = textOf(call),
                 .at = call.name.at});
            return;
        }
        const PlanNodeId added{tree_.size()};
        addForm(parent, known->second, segment);
        PlanNode& form = nodeAt(added);
        form.detail = joined(argumentsOf(call), form.detail);
        tree_.by_reference_.emplace(planHash(path_hash_[parent.index()], segment), added);
    }

    /// Adds the node of a form, or a link to it; `before` is the part of its path before the form's own segment.
    void addForm(PlanNodeId parent, std::size_t form, const std::string& before) {
        constexpr std::array kinds{PlanNodeKind::Competence, PlanNodeKind::Pattern, PlanNodeKind::Adopt,
                                   PlanNodeKind::Collection};
        constexpr std::array letters{"/C:", "/AP:", "/AD:", "/DC:"};
        const Form& what = plan_.forms[form];
        const bool too_many = tree_.size() >= PlanTree::most_nodes && drawn_at_[form].valid();
        tree_.truncated_ = tree_.truncated_ || (too_many && sharing_ == PlanSharing::Expanded);
        const bool recursive = open_at_[form].valid();
        const PlanNodeId link = recursive                                   ? open_at_[form]
                                : too_many || sharing_ == PlanSharing::Once ? drawn_at_[form]
                                                                            : PlanNodeId{};
        const PlanNodeId card = add({.kind = kinds[what.index()],
                                     .parent = parent,
                                     .link = link,
                                     .recursive = recursive,
                                     .segment = before + letters[what.index()] + std::to_string(number_of_form_[form]),
                                     .name = QString::fromStdString(nameOf(what).text),
                                     .detail = std::visit([](const auto& any) { return detailOf(any); }, what),
                                     .comment = std::visit([](const auto& any) { return commentOf(any); }, what),
                                     .at = nameOf(what).at});
        if (!link.valid())
            openForm(card, form);
    }

    /// Schedules the contents of a form.
    void openForm(PlanNodeId card, std::size_t form) {
        if (!drawn_at_[form].valid())
            drawn_at_[form] = card;
        open_at_[form] = card;
        std::visit(
            [&](const auto& any) {
                if constexpr (requires { any.goal; })
                    addSenses(card, any.goal, true);
                if constexpr (requires { any.levels; })
                    scheduleMembers(card, any.levels);
                if constexpr (requires { any.adopted; })
                    later([=, this, &any] { addCall(card, any.adopted, "/A:0"); });
                if constexpr (requires { any.steps; })
                    for (std::size_t i = 0; i < any.steps.size(); ++i)
                        later([=, this, &any] { addStep(card, any.steps[i], "/A:" + std::to_string(i)); });
            },
            plan_.forms[form]);
        later([=, this] { open_at_[form] = {}; });
    }

    void scheduleMembers(PlanNodeId card, const posh::Levels& levels) {
        int number = 0; // Counts all members of the form.
        for (std::size_t level = 0; level < levels.size(); ++level)
            for (const auto& member : levels[level]) {
                later([=, this, &levels, &member] {
                    addMember(card, member, static_cast<int>(level), levels[level].size() > 1, number);
                });
                ++number;
            }
    }

    /// Adds a drive of a collection or an element of a competence.
    void addMember(PlanNodeId parent, const posh::Member& part, int level, bool has_equals, int number) {
        const bool is_drive = nodeAt(parent).kind == PlanNodeKind::Collection;
        const PlanNodeId card = add({.kind = is_drive ? PlanNodeKind::Drive : PlanNodeKind::Element,
                                     .parent = parent,
                                     .level = level,
                                     .has_equals = has_equals,
                                     .segment = (is_drive ? "/DE:" : "/CE:") + std::to_string(number),
                                     .name = QString::fromStdString(part.name.text),
                                     .detail = is_drive ? driveDetail(part.frequency) : elementDetail(part),
                                     .comment = commentOf(part),
                                     .at = part.name.at});
        addSenses(card, part.trigger, false);
        later([=, this, &part] { addCall(card, part.action, "/A:0"); });
    }

    void addStep(PlanNodeId parent, const Step& step, const std::string& segment) {
        if (const auto* const test = std::get_if<SenseTest>(&step))
            add(senseNode(parent, *test, segment));
        else
            addCall(parent, std::get<Call>(step), segment);
    }

    /// Adds the senses of a trigger or goal to the card of `parent`.
    void addSenses(PlanNodeId parent, const Senses& senses, bool of_goal) {
        for (std::size_t i = 0; i < senses.size(); ++i) {
            PlanNode sense = senseNode(parent, senses[i], "/S:" + std::to_string(i));
            sense.in_card = true;
            sense.of_goal = of_goal;
            add(std::move(sense));
        }
        nodeAt(parent).senses = static_cast<int>(senses.size());
    }

    static PlanNode senseNode(PlanNodeId parent, const SenseTest& test, const std::string& segment) {
        return {.kind = PlanNodeKind::Sense,
                .parent = parent,
                .segment = segment,
                .name = textOf(test.call),
                .detail = comparison(test),
                .at = test.call.name.at};
    }

    /// Sets the end of each subtree and the list of cards below each card.
    void finish() {
        auto& first_child = tree_.first_child_;
        first_child.assign(tree_.nodes_.size() + 1, 0);
        for (const PlanNodeId node : tree_.nodes() | std::views::reverse) {
            PlanNode& what = nodeAt(node);
            what.end = std::max(what.end, PlanNodeId{node.value + 1});
            if (!what.parent.valid())
                continue;
            PlanNode& parent = nodeAt(what.parent);
            parent.end = std::max(parent.end, what.end);
            if (!what.in_card)
                ++first_child[what.parent.index() + 1];
        }
        std::partial_sum(first_child.begin(), first_child.end(), first_child.begin());
        tree_.children_.resize(static_cast<std::size_t>(first_child.back()));
        std::vector<int> next = first_child;
        for (const PlanNodeId node : tree_.nodes())
            if (const PlanNode& what = nodeAt(node); what.parent.valid() && !what.in_card)
                tree_.children_[static_cast<std::size_t>(next[what.parent.index()]++)] = node;
    }

    PlanTree& tree_;
    const Plan& plan_;
    PlanSharing sharing_;
    std::unordered_map<std::string, std::size_t> form_of_name_;
    std::vector<int> number_of_form_;  ///< by form: its number among forms of its kind
    std::vector<PlanNodeId> drawn_at_; ///< by form: the node that draws it, or none
    std::vector<PlanNodeId> open_at_;  ///< by form: the node that is being expanded now, or none
    std::vector<std::uint64_t> path_hash_;
    std::vector<std::function<void()>> stack_;
    std::vector<std::function<void()>> coming_;        ///< scheduled by the running task, in order
    std::unordered_map<std::uint64_t, int> seen_keys_; ///< number of nodes so far by key of their names
};

PlanTree::PlanTree(const Plan& plan, PlanSharing sharing) {
    PlanTreeBuilder(*this, plan, sharing).build();
}

} // namespace usar::widgets
