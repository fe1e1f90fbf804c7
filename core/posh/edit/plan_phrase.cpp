#include "core/posh/edit/plan_phrase.h"

#include <string>

#include "core/base/text.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token.h"
#include "core/posh/model/keyword.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

/// Reads a phrase inside the text of a plan. Fails if the plan then has errors or more than one element or drive.
Result<Plan> readAround(std::string_view words, std::string_view before, std::string_view after) {
    const std::string text = std::string(before) + std::string(words) + "\n" + std::string(after);
    PlanReading reading = readPlan(text);
    for (const Finding& finding : reading.findings)
        if (severityOf(finding.code) == Severity::Error && finding.code != Code::FreeVariable)
            return failure(finding.message, inQuotes(words));
    const Levels* const levels = reading.plan.forms.size() == 1 ? levelsIn(reading.plan.forms[0]) : nullptr;
    const bool is_one = levels && levels->size() == 1 && levels->front().size() == 1;
    if (!is_one || !reading.plan.remarks.above.empty())
        return failure("this is more than one part", inQuotes(words), "write one only");
    return std::move(reading.plan);
}

Result<Member> readElementAround(std::string_view words, std::string_view before, std::string_view after) {
    auto plan = readAround(words, "((C c (elements ((e " + std::string(before), std::string(after) + ")))))");
    if (!plan)
        return tl::unexpected(plan.error());
    Member element = (*levelsIn(plan->forms[0]))[0][0];
    if (element.name.text != "e" || !element.remarks.beside.empty() || !element.remarks.above.empty())
        return failure("a comment cannot be here", inQuotes(words), "write it in the text");
    return element;
}

} // namespace

Result<SenseTest> readSensePhrase(std::string_view words) {
    words = trimmed(words);
    const bool has_parentheses = words.starts_with('(');
    auto element =
        readElementAround(words, has_parentheses ? "(trigger (" : "(trigger ((", has_parentheses ? ")) x" : "))) x");
    if (!element)
        return tl::unexpected(element.error());
    if (element->trigger.size() != 1 || element->action.name.text != "x")
        return failure("this is not one sense", inQuotes(words), "write it as Distance 0.3 <");
    return std::move(element->trigger.front());
}

Result<Senses> readSensesPhrase(std::string_view words) {
    words = trimmed(words);
    if (words.empty() || words == "nil")
        return Senses();
    if (!words.starts_with('(')) {
        auto one = readSensePhrase(words);
        if (one)
            return Senses{*std::move(one)};
    }
    const bool is_list = words.starts_with("((") && words.ends_with("))");
    auto element = readElementAround(words, is_list ? "(trigger " : "(trigger (", is_list ? ") x" : ")) x");
    if (!element)
        return tl::unexpected(element.error());
    if (element->action.name.text != "x")
        return failure("this is more than senses", inQuotes(words), "write them as (Distance 0.3 <) (Loaded false)");
    return std::move(element->trigger);
}

Result<Call> readCallPhrase(std::string_view words) {
    words = trimmed(words);
    auto element = readElementAround(words, "nil ", "");
    if (!element)
        return tl::unexpected(element.error());
    if (element->retries || element->comment || !element->trigger.empty())
        return failure("this is more than an act", inQuotes(words), "write it as DriveTo(2.5)");
    return std::move(element->action);
}

Result<std::optional<Literal>> readRetriesPhrase(std::string_view words) {
    words = trimmed(words);
    if (words.empty())
        return std::nullopt;
    auto element = readElementAround(words, "x ", "");
    if (!element)
        return tl::unexpected(element.error());
    if (!element->retries || element->comment || element->action.name.text != "x" || !element->action.arguments.empty())
        return failure("this is not a whole number", inQuotes(words), "write how often it may start, such as 3");
    return std::move(element->retries);
}

Result<std::optional<Interval>> readIntervalPhrase(std::string_view words, bool rates_allowed) {
    words = trimmed(words);
    if (words.empty())
        return std::nullopt;
    const bool has_parentheses = words.starts_with('(');
    const std::string open = has_parentheses ? "" : "(";
    const std::string close = has_parentheses ? "" : ")";
    auto plan = rates_allowed ? readAround(words, "((DC d (drives ((e x " + open, close + ")))))")
                              : readAround(words, "((C c " + open, close + "(elements ((e x)))))");
    if (!plan)
        return tl::unexpected(plan.error());
    const Form& form = plan->forms[0];
    const auto found = rates_allowed ? (*levelsIn(form))[0][0].frequency : std::get<Competence>(form).time_limit;
    if (!found || !nameOf(form).text.starts_with(rates_allowed ? 'd' : 'c'))
        return failure("this is not a time", inQuotes(words),
                       rates_allowed ? "write seconds 2 or hz 5" : "write seconds 2");
    return found;
}

std::string phraseOf(const SenseTest& test) {
    std::string text;
    appendTest(text, test);
    return text.substr(1, text.size() - 2);
}

std::string sensesPhrase(const Plan& plan, const PlanPart& owner) {
    std::string text;
    for (const NamedPart& named : partsOf(plan)) {
        const SenseTest* const test = isStep(plan, named.part) ? nullptr : senseOf(plan, named.part);
        if (!test || ownerOf(named.part) != owner)
            continue;
        text += text.empty() ? "" : " ";
        appendTest(text, *test);
    }
    return text;
}

std::string limitPhrase(const Plan& plan, const PlanPart& owner) {
    std::string text;
    if (!nameOf(plan, owner))
        return text;
    if (owner.kind == PartKind::Member) {
        const Member& member = *memberOf(plan, owner);
        appendInterval(text, member.frequency);
        if (member.retries)
            appendLiteral(text, *member.retries);
    } else {
        if (const auto* const limit = fieldOf<const std::optional<Interval>>(
                plan.forms[owner.form], [](const auto& any) -> decltype(&any.time_limit) { return &any.time_limit; }))
            appendInterval(text, *limit);
    }
    const bool has_parentheses = text.starts_with(" (");
    return has_parentheses ? text.substr(2, text.size() - 3) : text;
}

Result<void> checkName(std::string_view name, bool dots_allowed) {
    const TokenList list = tokenize(name.substr(0, 200));
    const bool is_one =
        list.tokens.size() == 2 && list.tokens[0].kind == TokenKind::Name && list.tokens[0].at.length == name.size();
    const bool has_dot = name.find('.') != std::string_view::npos;
    if (!is_one || !list.warnings.empty() || (has_dot && !dots_allowed))
        return failure("this is not a name", inQuotes(name),
                       "begin with a letter and write letters, digits, - and _ only");
    if (keywordOf(name) != Keyword::None)
        return failure("this is a word of the language", inQuotes(name), "choose another name");
    return {};
}

} // namespace usar::posh
