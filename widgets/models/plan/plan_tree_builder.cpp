#include "widgets/models/plan/plan_tree_builder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <QObject>

#include "core/posh/language/plan_text.h"
#include "core/posh/model/plan_walk.h"

namespace usar::widgets {

namespace {

using namespace usar::posh;

QString fromText(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString spelled(const Literal& literal) {
    std::string text;
    appendLiteral(text, literal);
    return fromText(text);
}

QString textOf(const Call& call) {
    std::string text;
    appendCall(text, call);
    return fromText(text);
}

/// Returns the text of a call after the name of the form.
QString argumentsOf(const Call& call) {
    return textOf(call).mid(fromText(call.name.text).size());
}

QString comparison(const SenseTest& test) {
    if (!test.operand)
        return {};
    const QString sign = test.predicate ? fromText(toText(*test.predicate)) : QStringLiteral("==");
    return (sign == u"==" ? QStringLiteral("=") : sign) + u' ' + spelled(*test.operand);
}

QString frequencyText(const std::optional<Interval>& frequency) {
    if (!frequency)
        return {};
    const QString amount = spelled(frequency->amount);
    switch (frequency->unit) {
    case Unit::Hz:
        return QObject::tr("at most %1 Hz").arg(amount);
    case Unit::PerMinute:
        return QObject::tr("at most %1 a minute").arg(amount);
    case Unit::Ticks:
        return QObject::tr("every %1 cycles").arg(amount);
    case Unit::None:
        return numberOf(frequency->amount.value) > 0.0 ? QObject::tr("every %1 ms").arg(amount) : QString();
    case Unit::Hours:
        return QObject::tr("every %1 h").arg(amount);
    case Unit::Minutes:
        return QObject::tr("every %1 min").arg(amount);
    case Unit::Seconds:
        break;
    }
    return QObject::tr("every %1 s").arg(amount);
}

QString limitText(const std::optional<Interval>& limit) {
    if (!limit || (limit->unit == Unit::None && numberOf(limit->amount.value) <= 0.0))
        return {};
    const QString unit = limit->unit == Unit::Hours     ? QStringLiteral("h")
                         : limit->unit == Unit::Minutes ? QStringLiteral("min")
                         : limit->unit == Unit::Seconds ? QStringLiteral("s")
                                                        : QStringLiteral("ms");
    return QObject::tr("%1 %2 at most").arg(spelled(limit->amount), unit);
}

QString joined(const QString& first, const QString& second) {
    return first.isEmpty() || second.isEmpty() ? first + second : first + QStringLiteral(" · ") + second;
}

QString commentText(const std::optional<Literal>& comment) {
    const auto* const text = comment ? std::get_if<std::string>(&comment->value) : nullptr;
    return text ? fromText(*text) : QString();
}

PlanNodeKind kindOf(const Form& form) {
    constexpr std::array kinds{PlanNodeKind::Competence, PlanNodeKind::Pattern, PlanNodeKind::Adopt,
                               PlanNodeKind::Collection};
    return kinds[form.index()];
}

std::string letterOf(const Form& form) {
    constexpr std::array<const char*, 4> letters{"/C:", "/AP:", "/AD:", "/DC:"};
    return letters[form.index()];
}

QString formDetail(const Form& form) {
    return std::visit(
        [](const auto& any) {
            if constexpr (requires { any.time_limit; })
                return limitText(any.time_limit);
            else
                return QString();
        },
        form);
}

QString formComment(const Form& form) {
    return std::visit(
        [](const auto& any) {
            if constexpr (requires { any.comment; })
                return commentText(any.comment);
            else
                return QString();
        },
        form);
}

QString retryText(const posh::Member& element) {
    const auto limit = retryLimit(element);
    return !limit        ? QString()
           : *limit == 1 ? QObject::tr("at most 1 start")
                         : QObject::tr("at most %1 starts").arg(*limit);
}

} // namespace

PlanTreeBuilder::PlanTreeBuilder(PlanTree& tree, const Plan& plan, PlanSharing sharing)
    : tree_(tree)
    , plan_(plan)
    , sharing_(sharing)
    , drawn_at_(plan.forms.size(), -1)
    , open_at_(plan.forms.size(), -1) {
    indexForms();
}

void PlanTreeBuilder::indexForms() {
    std::array<int, 4> count{};
    for (std::size_t i = 0; i < plan_.forms.size(); ++i) {
        const Form& form = plan_.forms[i];
        number_of_form_.push_back(count[form.index()]++);
        if (!std::holds_alternative<Collection>(form))
            form_of_name_.emplace(nameOf(form).text, i);
    }
}

void PlanTreeBuilder::build() {
    if (plan_.forms.empty())
        return;
    const std::vector<std::size_t> unreached = unreachedForms();
    std::vector<std::size_t> roots = unreached;
    for (std::size_t i = 0; i < plan_.forms.size(); ++i)
        if (std::holds_alternative<Collection>(plan_.forms[i]))
            roots.insert(roots.begin(), i);
    int parent = -1;
    if (!unreached.empty()) {
        PlanNode plan;
        plan.segment = "/P:0";
        plan.name = plan_.documentation ? commentText(plan_.documentation->title) : QObject::tr("Plan");
        plan.detail = collectionOf(plan_) ? QObject::tr("with unused parts") : QObject::tr("no drive collection");
        parent = add(plan);
    }
    for (const std::size_t root : roots)
        later(parent, Root{root});
    pushComing();
    while (!stack_.empty()) {
        const Task task = std::move(stack_.back());
        stack_.pop_back();
        run(task);
        pushComing();
    }
    finish();
}

/// Returns the forms that no collection leads to, without their descendants: first those that no form names, then one
/// form of each circle that only names itself.
std::vector<std::size_t> PlanTreeBuilder::unreachedForms() const {
    std::vector<bool> reached(plan_.forms.size(), false);
    std::vector<bool> named(plan_.forms.size(), false);
    for (std::size_t i = 0; i < plan_.forms.size(); ++i) {
        if (std::holds_alternative<Collection>(plan_.forms[i]))
            markReachable(i, reached);
        forEachCall(plan_.forms[i], [&](const Call& call, bool is_sense) {
            const auto known = form_of_name_.find(call.name.text);
            if (!is_sense && known != form_of_name_.end())
                named[known->second] = true;
        });
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

void PlanTreeBuilder::markReachable(std::size_t form, std::vector<bool>& reached) const {
    std::vector<std::size_t> open{form};
    reached[form] = true;
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        forEachCall(plan_.forms[at], [&](const Call& call, bool is_sense) {
            const auto known = form_of_name_.find(call.name.text);
            if (is_sense || known == form_of_name_.end() || reached[known->second])
                return;
            reached[known->second] = true;
            open.push_back(known->second);
        });
    }
}

void PlanTreeBuilder::pushComing() {
    for (auto task = coming_.rbegin(); task != coming_.rend(); ++task)
        stack_.push_back(std::move(*task));
    coming_.clear();
}

void PlanTreeBuilder::run(const Task& task) {
    if (const auto* const reference = std::get_if<Reference>(&task.what))
        addReference(task.parent, *reference);
    else if (const auto* const member = std::get_if<Member>(&task.what))
        addMember(task.parent, *member);
    else if (const auto* const step = std::get_if<SenseStep>(&task.what))
        addSenseStep(task.parent, *step);
    else if (const auto* const root = std::get_if<Root>(&task.what))
        addForm(task.parent, root->form, task.parent < 0 ? "/P:0" : "");
    else
        open_at_[std::get<Close>(task.what).form] = -1;
}

int PlanTreeBuilder::add(PlanNode node) {
    const bool is_root = node.parent < 0;
    const auto parent = static_cast<std::size_t>(node.parent);
    node.depth = is_root ? 0 : tree_.nodes_[parent].depth + 1;
    const std::uint64_t name_key =
        planHash(is_root ? plan_hash_start : tree_.nodes_[parent].key, "/" + node.name.toStdString());
    const int namesakes = seen_keys_[name_key]++;
    node.key = namesakes == 0 ? name_key : planHash(name_key, "#" + std::to_string(namesakes));
    const std::uint64_t hash = planHash(is_root ? plan_hash_start : path_hash_[parent], node.segment);
    const int number = tree_.size();
    tree_.by_path_.emplace(hash, number);
    path_hash_.push_back(hash);
    tree_.nodes_.push_back(std::move(node));
    return number;
}

void PlanTreeBuilder::addReference(int parent, const Reference& reference) {
    const auto known = form_of_name_.find(reference.call->name.text);
    if (known != form_of_name_.end()) {
        const int before = tree_.size();
        addForm(parent, known->second, reference.segment);
        PlanNode& form = tree_.nodes_[static_cast<std::size_t>(before)];
        form.detail = joined(argumentsOf(*reference.call), form.detail);
        tree_.by_reference_.emplace(planHash(path_hash_[static_cast<std::size_t>(parent)], reference.segment), before);
        return;
    }
    PlanNode act;
    act.kind = PlanNodeKind::Act;
    act.parent = parent;
    act.segment = reference.segment;
    act.name = textOf(*reference.call);
    act.at = reference.call->name.at;
    add(std::move(act));
}

void PlanTreeBuilder::addForm(int parent, std::size_t form, const std::string& before) {
    const Form& what = plan_.forms[form];
    PlanNode node;
    node.kind = kindOf(what);
    node.parent = parent;
    node.segment = before + letterOf(what) + std::to_string(number_of_form_[form]);
    node.name = fromText(nameOf(what).text);
    node.detail = formDetail(what);
    node.comment = formComment(what);
    node.at = nameOf(what).at;
    node.recursive = open_at_[form] >= 0;
    const bool too_many = tree_.size() >= PlanTree::most_nodes && drawn_at_[form] >= 0;
    tree_.truncated_ = tree_.truncated_ || (too_many && sharing_ == PlanSharing::Expanded);
    if (node.recursive)
        node.link = open_at_[form];
    else if (too_many || sharing_ == PlanSharing::Once)
        node.link = drawn_at_[form];
    const bool is_link = node.link >= 0;
    const int number = add(std::move(node));
    if (!is_link)
        openForm(number, form);
}

void PlanTreeBuilder::openForm(int node, std::size_t form) {
    if (drawn_at_[form] < 0)
        drawn_at_[form] = node;
    open_at_[form] = node;
    std::visit(
        [&](const auto& any) {
            if constexpr (requires { any.goal; })
                addSenses(node, any.goal, true);
            int number = 0;
            if constexpr (requires { any.levels; })
                for (std::size_t level = 0; level < any.levels.size(); ++level)
                    for (const auto& member : any.levels[level])
                        later(node, Member{&member, static_cast<int>(level), any.levels[level].size() > 1, number++});
            if constexpr (requires { any.adopted; })
                later(node, Reference{&any.adopted, "/A:0"});
            if constexpr (requires { any.steps; })
                for (const Step& step : any.steps) {
                    if (const auto* const test = std::get_if<SenseTest>(&step))
                        later(node, SenseStep{test, number++});
                    else
                        later(node, Reference{&std::get<Call>(step), "/A:" + std::to_string(number++)});
                }
        },
        plan_.forms[form]);
    later(node, Close{form});
}

void PlanTreeBuilder::addMember(int parent, const Member& member) {
    PlanNode node;
    node.parent = parent;
    node.level = member.level;
    node.has_equals = member.has_equals;
    node.name = fromText(member.part->name.text);
    node.comment = commentText(member.part->comment);
    node.at = member.part->name.at;
    const bool is_drive = tree_[parent].kind == PlanNodeKind::Collection;
    node.kind = is_drive ? PlanNodeKind::Drive : PlanNodeKind::Element;
    node.segment = (is_drive ? "/DE:" : "/CE:") + std::to_string(member.number);
    node.detail = is_drive ? frequencyText(member.part->frequency) : retryText(*member.part);
    const int number = add(std::move(node));
    addSenses(number, member.part->trigger, false);
    later(number, Reference{&member.part->action, "/A:0"});
}

void PlanTreeBuilder::addSenses(int parent, const Senses& senses, bool of_goal) {
    for (std::size_t i = 0; i < senses.size(); ++i) {
        PlanNode sense;
        sense.kind = PlanNodeKind::Sense;
        sense.parent = parent;
        sense.in_card = true;
        sense.of_goal = of_goal;
        sense.segment = "/S:" + std::to_string(i);
        sense.name = textOf(senses[i].call);
        sense.detail = comparison(senses[i]);
        sense.at = senses[i].call.name.at;
        add(std::move(sense));
    }
    tree_.nodes_[static_cast<std::size_t>(parent)].senses = static_cast<int>(senses.size());
}

void PlanTreeBuilder::addSenseStep(int parent, const SenseStep& step) {
    PlanNode sense;
    sense.kind = PlanNodeKind::Sense;
    sense.parent = parent;
    sense.segment = "/A:" + std::to_string(step.number);
    sense.name = textOf(step.test->call);
    sense.detail = comparison(*step.test);
    sense.at = step.test->call.name.at;
    add(std::move(sense));
}

/// Sets the end of each subtree and the list of cards below each card.
void PlanTreeBuilder::finish() {
    auto& nodes = tree_.nodes_;
    std::vector<int> count(nodes.size() + 1, 0);
    for (std::size_t i = nodes.size(); i-- > 0;) {
        nodes[i].end = std::max(nodes[i].end, static_cast<int>(i) + 1);
        if (nodes[i].parent < 0)
            continue;
        auto& parent = nodes[static_cast<std::size_t>(nodes[i].parent)];
        parent.end = std::max(parent.end, nodes[i].end);
        if (!nodes[i].in_card)
            ++count[static_cast<std::size_t>(nodes[i].parent)];
    }
    tree_.first_child_.assign(nodes.size() + 1, 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        tree_.first_child_[i + 1] = tree_.first_child_[i] + count[i];
    tree_.children_.resize(static_cast<std::size_t>(tree_.first_child_.back()));
    std::vector<int> next = tree_.first_child_;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent >= 0 && !nodes[i].in_card)
            tree_.children_[static_cast<std::size_t>(next[static_cast<std::size_t>(nodes[i].parent)]++)] =
                static_cast<int>(i);
}

} // namespace usar::widgets
