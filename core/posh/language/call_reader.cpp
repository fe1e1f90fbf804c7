#include "core/posh/language/form_reader.h"

#include <cstdint>
#include <string>

#include "core/base/numbers.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/posh/model/literal.h"
#include "core/posh/model/name_set.h"

namespace usar::posh {

namespace {

std::optional<Predicate> predicateOf(std::string_view word) {
    for (const Predicate predicate : {Predicate::Equal, Predicate::NotEqual, Predicate::Less, Predicate::Greater,
                                      Predicate::LessOrEqual, Predicate::GreaterOrEqual})
        if (word == toText(predicate))
            return predicate;
    return word == "=" ? std::optional(Predicate::Equal) : std::nullopt;
}

bool atAssignment(const TokenCursor& cursor, std::size_t ahead) {
    return cursor.at(TokenKind::Predicate, ahead) && cursor.word(ahead) == "=";
}

void takeVariable(TokenCursor& cursor, Variable& variable) {
    variable.name = cursor.word().substr(1);
    variable.at = cursor.peek().at;
    cursor.advance();
}

template <class Number>
bool setNumber(std::optional<Number> number, Value& value) {
    if (number)
        value.emplace<Number>(*number);
    return number.has_value();
}

/// Sets the value of the current token. Returns false if a number does not fit into 64 bits. Constructs the value in
/// place, because a plan consists mostly of values.
bool setValue(const TokenCursor& cursor, Value& value) {
    const std::string_view word = cursor.word();
    switch (cursor.peek().kind) {
    case TokenKind::Integer:
        return setNumber<std::int64_t>(readInteger(word), value);
    case TokenKind::Float:
        return setNumber(floatOf(word), value);
    case TokenKind::String:
        value = unescaped(word.substr(1, word.size() - 2));
        return true;
    case TokenKind::Symbol:
        value.emplace<Symbol>().text = word.substr(1);
        return true;
    default:
        break;
    }
    const Keyword keyword = cursor.keyword();
    if (keyword == Keyword::Nil)
        value = std::monostate();
    else if (isLiteral(keyword))
        value = keyword == Keyword::True;
    else
        value.emplace<Symbol>().text = word;
    return true;
}

/// Takes the current token as a value; a bare word becomes a symbol.
bool takeValue(TokenCursor& cursor, Literal& literal) {
    if (!setValue(cursor, literal.value))
        return cursor.fail(Code::MalformedNumber,
                           "the number " + inQuotes(cursor.word()) + " does not fit into 64 bits; write a smaller one");
    literal.spelling = cursor.word();
    literal.at = cursor.peek().at;
    cursor.advance();
    return true;
}

bool bareName(TokenCursor& cursor) {
    const std::string word(cursor.word());
    return cursor.fail(Code::BareNameAsValue, "a bare name is not a value here; write '" + word + " for a symbol, \"" +
                                                  word + "\" for a text or $" + word + " for a parameter");
}

/// Reads the value or variable of an argument.
bool readArgumentValue(TokenCursor& cursor, std::variant<Literal, Variable>& value) {
    if (cursor.at(TokenKind::Variable)) {
        takeVariable(cursor, value.emplace<Variable>());
        return true;
    }
    if (atValue(cursor))
        return takeValue(cursor, value.emplace<Literal>());
    if (cursor.at(TokenKind::Name))
        return bareName(cursor);
    return cursor.unexpected("a value", "a number, a \"text\", a 'symbol or a $variable");
}

bool readArgument(TokenCursor& cursor, bool after_named, NameSet& seen, Argument& argument) {
    const Spot begin = cursor.peek().at;
    if (cursor.at(TokenKind::Variable) && atAssignment(cursor, 1)) {
        if (!seen.insert(cursor.word()))
            return cursor.fail(Code::ArgumentTwice,
                               "the argument " + inQuotes(cursor.word()) + " is given twice; write it once");
        argument.name = cursor.word().substr(1);
        cursor.advance();
        cursor.advance();
    } else if (after_named && (cursor.at(TokenKind::Variable) || atValue(cursor))) {
        return cursor.fail(Code::PositionalAfterNamed,
                           "an argument without a name follows one with a name; write it before the named ones");
    }
    if (!readArgumentValue(cursor, argument.value))
        return false;
    argument.at = cursor.spotSince(begin);
    return true;
}

std::string unitMend(std::string_view word, bool rates_allowed) {
    std::vector<std::string> known{"hours", "minutes", "seconds", "none"};
    if (rates_allowed)
        known.insert(known.end(), {"hz", "pm", "ticks"});
    return "write " + nearestWord(lowerCase(word), known) + (rates_allowed ? "" : ", which is a time");
}

bool checkAmount(TokenCursor& cursor, Unit unit) {
    if (!cursor.atNumber())
        return cursor.fail(Code::NumberMissing, "a number is missing after the unit " + inQuotes(toText(unit)) +
                                                    "; write one, such as (" + std::string(toText(unit)) + " 2)");
    const double amount = floatOf(cursor.word()).value_or(1.0); // takeValue reports a number that is too large
    const bool is_rate = unit == Unit::Hz || unit == Unit::PerMinute;
    if (amount < 0.0 || (is_rate && amount == 0.0))
        return cursor.fail(Code::NumberOutOfRange, amount < 0.0 ? "a time cannot be negative; write a number from 0 up"
                                                                : "a rate cannot be zero; write a greater number");
    return true;
}

/// Returns the advice for a keyword that is used as a name. The built-in senses `true` and `false` have proper names.
const char* otherNameFor(Keyword keyword) {
    if (keyword == Keyword::True)
        return "write succeed";
    return keyword == Keyword::False ? "write fail" : "choose another";
}

} // namespace

bool readName(TokenCursor& cursor, std::string_view whose, Name& name) {
    if (!cursor.at(TokenKind::Name))
        return cursor.unexpected("the name " + std::string(whose), "a name");
    if (cursor.keyword() != Keyword::None)
        cursor.report(Code::KeywordAsName, cursor.peek().at,
                      inQuotes(cursor.word()) + " is a word of the language and is read as a name here; " +
                          otherNameFor(cursor.keyword()));
    name.text = cursor.word();
    name.at = cursor.peek().at;
    cursor.advance();
    return true;
}

bool atValue(const TokenCursor& cursor) {
    return cursor.atNumber() || cursor.at(TokenKind::String) || cursor.at(TokenKind::Symbol) ||
           isLiteral(cursor.keyword());
}

bool readValue(TokenCursor& cursor, Literal& literal) {
    if (atValue(cursor))
        return takeValue(cursor, literal);
    if (cursor.at(TokenKind::Name))
        return bareName(cursor);
    return cursor.unexpected("a value", "a number, a \"text\" or a 'symbol");
}

bool readComment(TokenCursor& cursor, std::optional<Literal>& comment) {
    return !cursor.at(TokenKind::String) || takeValue(cursor, comment.emplace());
}

bool readFormals(TokenCursor& cursor, std::vector<Formal>& formals) {
    if (cursor.keyword() != Keyword::Vars)
        return true;
    cursor.advance();
    if (!cursor.take(TokenKind::Open, "the parameters", "vars($name=value)"))
        return false;
    NameSet seen;
    for (;;) {
        if (!cursor.at(TokenKind::Variable))
            return cursor.unexpected("a parameter", "$name=value");
        if (!seen.insert(cursor.word()))
            return cursor.fail(Code::ParameterTwice, "the parameter " + inQuotes(cursor.word()) +
                                                         " is declared twice; give the second another name");
        Formal& formal = formals.emplace_back();
        takeVariable(cursor, formal.variable);
        if (!atAssignment(cursor, 0))
            return cursor.fail(Code::ParameterWithoutDefault, "the parameter $" + formal.variable.name +
                                                                  " has no default; write $" + formal.variable.name +
                                                                  "=value");
        cursor.advance();
        if (!readValue(cursor, formal.value))
            return false;
        if (!cursor.at(TokenKind::Comma))
            return cursor.take(TokenKind::Close, "a comma or the end of the parameters", ", or )");
        cursor.advance();
    }
}

bool readArguments(TokenCursor& cursor, std::vector<Argument>& arguments) {
    cursor.advance();
    NameSet seen;
    arguments.reserve(cursor.at(TokenKind::Close, 1) ? 1 : 2);
    for (;;) {
        const bool after_named = !arguments.empty() && !arguments.back().name.empty();
        if (!readArgument(cursor, after_named, seen, arguments.emplace_back()))
            return false;
        if (!cursor.at(TokenKind::Comma))
            return cursor.take(TokenKind::Close, "a comma or the end of the arguments", ", or )");
        cursor.advance();
    }
}

bool readCall(TokenCursor& cursor, std::string_view whose, Call& call) {
    return readName(cursor, whose, call.name) && (!cursor.at(TokenKind::Open) || readArguments(cursor, call.arguments));
}

bool readSenseTest(TokenCursor& cursor, SenseTest& test) {
    cursor.advance();
    if (!readCall(cursor, "of a sense", test.call))
        return false;
    if (cursor.at(TokenKind::Predicate))
        return cursor.fail(Code::MisplacedPredicate,
                           "the comparison stands before its value; write the value first, as (" + test.call.name.text +
                               " 3 " + std::string(cursor.word()) + ')');
    if (atValue(cursor) || cursor.at(TokenKind::Name)) {
        if (!takeValue(cursor, test.operand.emplace()))
            return false;
        if (cursor.at(TokenKind::Predicate)) {
            test.predicate = predicateOf(cursor.word());
            cursor.advance();
        } else if (!cursor.at(TokenKind::Close)) {
            return cursor.fail(Code::MisplacedPredicate, "a comparison or ) must follow the value, not " +
                                                             inQuotes(cursor.word()) +
                                                             "; write one of == != < > <= >=, or )");
        }
        return cursor.take(TokenKind::Close, "the end of the sense", ")");
    }
    return cursor.take(TokenKind::Close, "a value or the end of the sense",
                       "(sense), (sense value) or (sense value <)");
}

bool readSenses(TokenCursor& cursor, Senses& senses) {
    if (cursor.keyword() == Keyword::Nil) {
        cursor.advance();
        return true;
    }
    if (!cursor.take(TokenKind::Open, "a list of senses", "((sense) (sense value <)), or nil"))
        return false;
    senses.reserve(2);
    while (!cursor.at(TokenKind::Close)) {
        const bool is_test = cursor.at(TokenKind::Open);
        if (!is_test && !cursor.at(TokenKind::Name))
            return cursor.unexpected("a sense", "(sense) or (sense value <)");
        SenseTest& test = senses.emplace_back();
        if (is_test ? !readSenseTest(cursor, test) : !readName(cursor, "of a sense", test.call.name))
            return false;
    }
    cursor.advance();
    return true;
}

bool readGoal(TokenCursor& cursor, Senses& goal) {
    return cursor.take(TokenKind::Open, "the goal", "(goal ((sense)))") &&
           cursor.takeKeyword(Keyword::Goal, "the word goal", "(goal ((sense)))") && readSenses(cursor, goal) &&
           cursor.take(TokenKind::Close, "the end of the goal", ")");
}

bool readInterval(TokenCursor& cursor, bool rates_allowed, std::optional<Interval>& interval) {
    cursor.advance();
    if (!cursor.at(TokenKind::Name))
        return cursor.unexpected("a unit", "(seconds 2)");
    const auto unit = unitOf(cursor.keyword());
    if (!unit || (!rates_allowed && !isTimeUnit(*unit)))
        return cursor.fail(Code::UnknownUnit, inQuotes(cursor.word()) +
                                                  (unit ? " is a rate and not a time limit; " : " is not a unit; ") +
                                                  unitMend(cursor.word(), rates_allowed));
    interval.emplace().unit = *unit;
    interval->at = cursor.peek().at;
    cursor.advance();
    return checkAmount(cursor, *unit) && takeValue(cursor, interval->amount) &&
           cursor.take(TokenKind::Close, "the end of the time", ")");
}

} // namespace usar::posh
