// Quick fixes for errors in characters and grammar.
#include <algorithm>
#include <cmath>

#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/posh/edit/fix_finder.h"
#include "core/posh/model/keyword.h"
#include "core/posh/model/literal.h"
#include "core/posh/model/utf8.h"

namespace usar::posh {

namespace {

/// Longer words are not compared, because comparing two words costs the product of their lengths.
constexpr std::size_t longest_word = 60;

bool belongsToName(char c) {
    return isLetter(c) || isDigit(c) || c == '_' || c == '-';
}

/// Returns the word without the characters that a name must not have and without empty parts between dots.
std::string cleaned(std::string_view word) {
    std::string name;
    for (const char c : word) {
        const bool starts = name.empty() || name.back() == '.';
        if (c == '.' ? !starts : belongsToName(c) && (!starts || isLetter(c) || c == '_'))
            name += c;
    }
    while (name.ends_with('.'))
        name.pop_back();
    return name;
}

std::string parentheses(std::size_t count) {
    return count == 1 ? "a parenthesis" : std::to_string(count) + " parentheses";
}

} // namespace

FixFinder::FixFinder(std::string_view text, const Finding& finding, const Vocabulary& vocabulary)
    : text_(text)
    , finding_(finding)
    , vocabulary_(vocabulary)
    , tokens_(tokenize(text))
    , reading_(readPlan(text)) {
    const auto after = std::ranges::upper_bound(tokens_.tokens, finding.at.offset, {},
                                                [](const Token& token) { return token.at.offset; });
    here_ = after == tokens_.tokens.begin() ? 0 : static_cast<std::size_t>(after - tokens_.tokens.begin()) - 1;
    part_ = partAt(reading_.plan, finding.at.offset);
}

std::vector<QuickFix> FixFinder::run() {
    using enum Code;
    struct Row {
        void (FixFinder::*find)();
        std::initializer_list<Code> codes;
    };
    static const Row rows[] = {
        {&FixFinder::fixCharacters,
         {IllegalCharacter, UnknownEscape, MalformedSymbol, DollarWithoutName, BadByte, OddSpace}},
        {&FixFinder::fixOpenString, {StringNeverClosed}},
        {&FixFinder::fixWord, {MalformedNumber, MalformedName}},
        {&FixFinder::fixParentheses, {NotAPlan, EndOfFile}},
        {&FixFinder::fixUnexpected, {UnexpectedToken, UnknownForm}},
        {&FixFinder::fixTextAfterPlan, {TextAfterPlan}},
        {&FixFinder::fixDocumentation, {LateDocumentation, DocumentationStrings, SecondCollection}},
        {&FixFinder::fixUnit, {UnknownUnit}},
        {&FixFinder::fixNumber, {NumberMissing, NumberOutOfRange, FractionalRetries}},
        {&FixFinder::fixPredicate, {MisplacedPredicate}},
        {&FixFinder::fixBareName, {BareNameAsValue}},
        {&FixFinder::fixArgumentPlace, {PositionalAfterNamed, ArgumentTwice}},
        {&FixFinder::fixParameter, {ParameterTwice, ParameterWithoutDefault}},
        {&FixFinder::fixEmptyList, {EmptyList}},
        {&FixFinder::fixDuplicate, {DuplicateName, DuplicateDrive, DuplicateElement}},
        {&FixFinder::fixSimply, {ReferenceCycle, NeverUsed, NoElements, ZeroRetries}},
        {&FixFinder::fixMissingCollection, {NoCollection, Fragment}},
        {&FixFinder::fixUnknownName, {UnknownPrimitive}},
        {&FixFinder::fixName, {PrimitiveNamedAsForm, NameStartsWithDigit, KeywordAsName}},
        {&FixFinder::fixVariable, {FreeVariable}},
        {&FixFinder::fixWrongUse, {WrongUse}},
        {&FixFinder::fixUnreached, {NeverReached}},
        {&FixFinder::fixFindingNothing, {MayFindNothing}},
        {&FixFinder::fixUndeclared, {UndeclaredArgument}},
    };
    for (const Row& row : rows)
        if (std::ranges::find(row.codes, finding_.code) != row.codes.end())
            (this->*row.find)();
    return std::move(fixes_);
}

void FixFinder::add(std::string title, std::vector<Splice> edits) {
    fixes_.push_back({std::move(title), std::move(edits)});
}

void FixFinder::add(std::string title, const Result<PlanEdit>& edit) {
    if (edit && edit->text != text_)
        add(std::move(title), difference(text_, edit->text));
}

void FixFinder::replace(std::string title, std::size_t begin, std::size_t end, std::string words) {
    add(std::move(title), std::vector<Splice>{{begin, end, std::move(words)}});
}

void FixFinder::replaceFound(const std::string& words) {
    replace("Write " + words, finding_.at.offset, finding_.at.end(), words);
}

void FixFinder::write(const std::string& words) {
    replace("Write " + words, beginOf(here_), endOf(here_), words);
}

void FixFinder::takeOut(std::size_t first_token, std::size_t last_token) {
    const std::size_t begin = beginOf(first_token);
    const std::size_t end = endOf(last_token);
    const bool blanks_around = begin > 0 && text_[begin - 1] == ' ' && (end == text_.size() || text_[end] != '\n');
    replace("Remove " + inQuotes(text_.substr(begin, end - begin)), blanks_around ? begin - 1 : begin, end, "");
}

void FixFinder::writeNearest(const std::vector<std::string>& known, std::size_t longest_distance, std::size_t most) {
    std::vector<std::pair<std::size_t, std::string>> near;
    const std::string wanted = lowerCase(found());
    if (wanted.size() > longest_word)
        return;
    for (const std::string& candidate : known) {
        const bool is_start = wanted.size() > 1 && lowerCase(candidate).starts_with(wanted);
        const std::size_t distance = is_start ? 1 : editDistance(wanted, lowerCase(candidate));
        if (distance <= longest_distance)
            near.emplace_back(distance, candidate);
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), most));
    for (const auto& [distance, candidate] : near)
        replaceFound(candidate);
}

std::size_t FixFinder::closing(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t i = open; i < tokens_.tokens.size(); ++i) {
        depth += token(i).kind == TokenKind::Open ? 1 : 0;
        if (token(i).kind == TokenKind::Close && --depth == 0)
            return i;
    }
    return tokens_.tokens.size() - 1;
}

std::size_t FixFinder::opening(std::size_t inside) const {
    std::size_t depth = 1;
    for (std::size_t i = inside; i-- > 0;) {
        depth += token(i).kind == TokenKind::Close ? 1 : 0;
        if (token(i).kind == TokenKind::Open && --depth == 0)
            return i;
    }
    return 0;
}

/// Fixes one wrong character by removing or replacing it.
void FixFinder::fixCharacters() {
    const std::size_t at = finding_.at.offset;
    const std::size_t length = at < text_.size() ? codePointAt(text_, at).length : 0;
    const std::string character = inQuotes(text_.substr(at, length));
    switch (finding_.code) {
    case Code::OddSpace:
        return replace("Write an ordinary blank", at, at + std::max<std::size_t>(finding_.at.length, length), " ");
    case Code::UnknownEscape:
        replace("Write a backslash", at, at + 1, "\\\\");
        return replace("Remove the backslash", at, at + 1, "");
    case Code::MalformedSymbol:
        if (text_.substr(at, length) != "'")
            replace("Write _ in place of " + character, at, at + length, "_");
        return replace("Remove " + character, at, at + length, "");
    default:
        replace("Remove " + character, at, at + length, "");
        if (finding_.code == Code::IllegalCharacter)
            replace("Write - in place of " + character, at, at + length, "-");
        if (endOf(here_) > at)
            takeOut(here_, here_);
    }
}

/// Fixes a string that is not closed. It was nearly always meant to end on its line, before the parentheses at the end
/// of it.
void FixFinder::fixOpenString() {
    const std::size_t at = finding_.at.offset;
    const std::size_t line_end = std::min(text_.find('\n', at), text_.size());
    std::size_t end = line_end;
    while (end > at + 1 && isSpace(text_[end - 1]))
        --end;
    std::size_t before_parentheses = end;
    while (before_parentheses > at + 1 &&
           (text_[before_parentheses - 1] == ')' || isSpace(text_[before_parentheses - 1])))
        --before_parentheses;
    for (std::size_t place = before_parentheses; place <= end; ++place)
        insert(place == end ? "Close the string at the end of the line" : "Close the string before the parentheses",
               place, "\"");
}

void FixFinder::fixWord() {
    const std::string_view whole = word(here_);
    for (std::size_t length = whole.size(); length-- > 1;) {
        const WordKind kind = classifyWord(whole.substr(0, length));
        if (kind.error || (kind.kind != TokenKind::Integer && kind.kind != TokenKind::Float))
            continue;
        write(std::string(whole.substr(0, length)));
        break;
    }
    if (const std::string name = cleaned(whole); !name.empty() && name != whole)
        write(name);
    if (finding_.code == Code::MalformedNumber)
        write("1");
}

void FixFinder::fixUnexpected() {
    writeNearest({"trigger", "goal", "drives", "elements", "vars", "documentation"}, 2, 2);
    if (finding_.code == Code::UnknownForm)
        for (const char* const keyword : {"C", "AP", "AD", "DC"})
            write(keyword);
    closeBeforeNextForm();
    if (here_ > 0) { // Perhaps a list was meant where there is a single item
        const std::size_t open = opening(here_);
        add("Put parentheses around it",
            {{beginOf(open), beginOf(open), "("}, {endOf(closing(open)), endOf(closing(open)), ")"}});
        insert("Write ) here", endOf(here_ - 1), ")");
    }
    const bool is_list = token(here_).kind == TokenKind::Open;
    const bool is_word = token(here_).kind != TokenKind::End;
    if (is_list && closing(here_) + 1 < tokens_.tokens.size())
        takeOut(here_, closing(here_));
    else if (is_word)
        takeOut(here_, here_);
    fixParentheses();
}

/// Closes the form before the first one that begins on a line of its own while that form is still open.
void FixFinder::closeBeforeNextForm() {
    std::size_t depth = 0;
    for (std::size_t i = 0; i + 1 < tokens_.tokens.size(); ++i) {
        const bool begins = token(i).kind == TokenKind::Open && token(i).first_on_line &&
                            beginsForm(keywordOf(word(i + 1))) && token(i + 2).kind == TokenKind::Name;
        if (begins && depth > 1 && i > 0)
            return insert("Close " + parentheses(depth - 1) + " before " +
                              inQuotes("(" + std::string(word(i + 1)) + ' ' + std::string(word(i + 2))),
                          endOf(i - 1), std::string(depth - 1, ')'));
        depth += token(i).kind == TokenKind::Open ? 1 : 0;
        depth -= token(i).kind == TokenKind::Close && depth > 0 ? 1 : 0;
    }
}

void FixFinder::fixParentheses() {
    const std::size_t last = tokens_.tokens.size() - 1;
    long depth = 0;
    for (std::size_t i = 0; i < last; ++i)
        depth += token(i).kind == TokenKind::Open ? 1 : token(i).kind == TokenKind::Close ? -1 : 0;
    if (finding_.code == Code::EndOfFile)
        closeBeforeNextForm();
    if (depth > 0 && last > 0) {
        const auto missing = static_cast<std::size_t>(depth);
        insert("Close " + parentheses(missing) + " at the end", endOf(last - 1), std::string(missing, ')'));
    }
    if (finding_.code == Code::NotAPlan)
        add("Put parentheses around the form and the plan", {{0, 0, "(("}, {text_.size(), text_.size(), "))\n"}});
    add("Put parentheses around the plan", {{0, 0, "("}, {text_.size(), text_.size(), "\n)\n"}});
    if (last == 0)
        insert("Write a plan that does nothing", text_.size(),
               "(\n  (DC life\n    (drives\n      ((idle doNothing))))\n)\n");
    else if (finding_.code == Code::NotAPlan)
        takeOut(here_, here_);
}

void FixFinder::fixTextAfterPlan() {
    const std::size_t last = tokens_.tokens.size() - 1;
    if (token(here_).kind == TokenKind::Close && here_ + 1 == last)
        takeOut(here_, here_);
    if (here_ > 0) { // One of the closing parentheses before it may be superfluous
        replace("Remove the ) before it", beginOf(here_ - 1), endOf(here_ - 1), "");
        add("Close the plan at the end",
            {{beginOf(here_ - 1), endOf(here_ - 1), ""}, {endOf(last - 1), endOf(last - 1), "\n)"}});
    }
    fixParentheses();
    if (here_ < last)
        takeOut(here_, last - 1);
}

void FixFinder::fixDocumentation() {
    const std::size_t open = token(here_).kind == TokenKind::Open ? here_ : opening(here_);
    const std::size_t close = closing(open);
    const std::string form(text_.substr(beginOf(open), endOf(close) - beginOf(open)));
    if (finding_.code == Code::LateDocumentation)
        add("Move it to the front", {{endOf(0), endOf(0), "\n  " + form}, {beginOf(open), endOf(close), ""}});
    if (finding_.code != Code::DocumentationStrings)
        return takeOut(open, close);
    std::size_t strings = 0;
    std::size_t superfluous = 0;
    for (std::size_t i = open; i < close; ++i)
        if (token(i).kind == TokenKind::String && ++strings == 4)
            superfluous = i;
    if (strings < 3)
        insert("Write empty texts for the rest", endOf(here_ - 1),
               std::string_view(R"( "" "" "")").substr(3 * strings));
    else if (superfluous > 0)
        takeOut(superfluous, close - 1);
}

void FixFinder::fixUnit() {
    const std::string wanted = lowerCase(word(here_).substr(0, longest_word));
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const char* const unit : {"seconds", "minutes", "hours", "hz", "pm", "ticks"}) {
        const bool is_start =
            std::string_view(unit).starts_with(wanted.substr(0, std::min<std::size_t>(3, wanted.size())));
        near.emplace_back(is_start ? 0 : editDistance(wanted, unit), unit);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, unit] : near)
        write(unit);
}

void FixFinder::fixNumber() {
    const std::string_view number = word(here_);
    if (finding_.code == Code::NumberMissing) {
        if (token(here_).kind != TokenKind::Close)
            write("1");
        return insert("Write 1", endOf(here_ - 1), " 1");
    }
    if (finding_.code == Code::FractionalRetries)
        if (const auto value = floatOf(number); value && std::abs(*value) < 1e9)
            write(std::to_string(std::llround(*value)));
    if (number.starts_with('-'))
        write(std::string(number.substr(1)));
    write("1");
}

void FixFinder::fixPredicate() {
    if (token(here_).kind == TokenKind::Predicate && token(here_ + 1).kind != TokenKind::Close) {
        const std::string value(word(here_ + 1));
        const std::string predicate(word(here_));
        replace("Write " + value + ' ' + predicate, beginOf(here_), endOf(here_ + 1), value + ' ' + predicate);
    }
    if (token(here_).kind != TokenKind::Predicate)
        for (const char* const predicate : {"==", "<", ">"})
            write(predicate);
    takeOut(here_, here_);
}

void FixFinder::fixBareName() {
    const std::string name(word(here_));
    for (const std::string& value : {"'" + name, '"' + name + '"', '$' + name})
        write(value);
    if (token(here_ - 1).kind == TokenKind::Open && token(here_ + 1).kind == TokenKind::Close)
        replace("Remove the argument", beginOf(here_ - 1), endOf(here_ + 1), "");
}

/// Moves or removes an argument, together with the comma before it: `, $name=value` or `, value`.
void FixFinder::fixArgumentPlace() {
    const bool is_named = token(here_ + 1).kind == TokenKind::Predicate;
    const std::size_t last = is_named ? here_ + 2 : here_;
    if (here_ == 0 || token(here_ - 1).kind != TokenKind::Comma)
        return;
    const std::size_t open = opening(here_);
    if (!is_named)
        add("Move it to the front",
            {{endOf(open), endOf(open), std::string(word(here_)) + ", "}, {beginOf(here_ - 1), endOf(last), ""}});
    replace("Remove the argument", beginOf(here_ - 1), endOf(last), "");
}

void FixFinder::fixParameter() {
    if (here_ == 0)
        return;
    if (finding_.code == Code::ParameterWithoutDefault) {
        for (const char* const value : {"0", "nil"})
            insert(std::string("Give it the value ") + value, endOf(here_ - 1), std::string("=") + value);
        return;
    }
    if (token(here_ - 1).kind == TokenKind::Comma)
        replace("Remove the second one", beginOf(here_ - 1), endOf(here_ + 2), "");
    replace("Name it " + std::string(word(here_)) + "2", beginOf(here_), endOf(here_), std::string(word(here_)) + "2");
}

void FixFinder::fixEmptyList() {
    const bool is_drives = here_ > 0 && keywordOf(word(here_ - 1)) == Keyword::Drives;
    insert(is_drives ? "Add a drive that does nothing" : "Add a step that does nothing", beginOf(here_),
           is_drives ? " ((idle doNothing))" : "doNothing");
}

} // namespace usar::posh
