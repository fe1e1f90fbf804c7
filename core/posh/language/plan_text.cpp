#include "core/posh/language/plan_text.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/posh/model/keyword.h"
#include "core/posh/model/literal.h"

namespace usar::posh {

namespace {

void appendArgument(std::string& out, const Argument& argument) {
    if (!argument.name.empty())
        out += '$' + argument.name + '=';
    if (const auto* const literal = std::get_if<Literal>(&argument.value))
        appendLiteral(out, *literal);
    else
        out += '$' + std::get<Variable>(argument.value).name;
}

} // namespace

void appendLiteral(std::string& out, const Literal& literal) {
    out += literal.spelling.empty() ? spelled(literal.value) : literal.spelling;
}

void appendCall(std::string& out, const Call& call) {
    out += call.name.text;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        out += i == 0 ? "(" : ", ";
        appendArgument(out, call.arguments[i]);
    }
    if (!call.arguments.empty())
        out += ')';
}

void appendTest(std::string& out, const SenseTest& test) {
    out += '(';
    appendCall(out, test.call);
    if (test.operand) {
        out += ' ';
        appendLiteral(out, *test.operand);
        if (test.predicate)
            (out += ' ') += toText(*test.predicate);
    }
    out += ')';
}

void appendStep(std::string& out, const Step& step) {
    if (const auto* const test = std::get_if<SenseTest>(&step))
        appendTest(out, *test);
    else
        appendCall(out, std::get<Call>(step));
}

void appendSenses(std::string& out, const Senses& senses) {
    if (senses.empty()) {
        out += "nil";
        return;
    }
    for (std::size_t i = 0; i < senses.size(); ++i) {
        out += i == 0 ? '(' : ' ';
        appendTest(out, senses[i]);
    }
    out += ')';
}

void appendFormals(std::string& out, const std::vector<Formal>& formals) {
    for (std::size_t i = 0; i < formals.size(); ++i) {
        out += i == 0 ? " vars($" : ", $";
        out += formals[i].variable.name + '=';
        appendLiteral(out, formals[i].value);
    }
    if (!formals.empty())
        out += ')';
}

void appendInterval(std::string& out, const std::optional<Interval>& interval) {
    if (!interval)
        return;
    ((out += " (") += toText(interval->unit)) += ' ';
    appendLiteral(out, interval->amount);
    out += ')';
}

void appendGoal(std::string& out, const Senses& goal) {
    if (goal.empty())
        return;
    out += " (goal ";
    appendSenses(out, goal);
    out += ')';
}

void appendComment(std::string& out, const std::optional<Literal>& comment) {
    if (!comment)
        return;
    out += ' ';
    appendLiteral(out, *comment);
}

void appendMember(std::string& out, const Member& member, std::size_t name_width) {
    out += '(' + member.name.text + ' ';
    if (member.name.text.size() + 1 < name_width)
        out.append(name_width - member.name.text.size() - 1, ' ');
    if (!member.trigger.empty()) {
        out += "(trigger ";
        appendSenses(out, member.trigger);
        out += ") ";
    } else if (keywordOf(member.action.name.text) == Keyword::Nil) {
        out += "nil "; // Without it, the action `nil` would be read as the absent trigger
    }
    appendCall(out, member.action);
    appendInterval(out, member.frequency);
    appendComment(out, member.retries);
    appendComment(out, member.comment);
    out += ')';
}

std::string commentText(std::string_view remark) {
    std::string text(remark);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const bool has_mark = text.starts_with(';') || text.starts_with('#');
    return text.empty() || has_mark ? text : "; " + text;
}

std::string keywordText(const Collection& collection) {
    constexpr std::array<std::string_view, 4> words{"DC", "RDC", "SDC", "SRDC"};
    const bool fits = collectionKind(keywordOf(collection.keyword)) == collection.kind;
    return fits ? collection.keyword : std::string(words[static_cast<std::size_t>(collection.kind)]);
}

std::string headText(const Competence& competence) {
    std::string text = "(C " + competence.name.text;
    appendFormals(text, competence.formals);
    appendInterval(text, competence.time_limit);
    appendGoal(text, competence.goal);
    return text;
}

std::string headText(const Collection& collection) {
    std::string text = '(' + keywordText(collection) + ' ' + collection.name.text;
    appendGoal(text, collection.goal);
    return text;
}

} // namespace usar::posh
