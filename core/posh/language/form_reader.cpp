#include "core/posh/language/form_reader.h"

#include <string>

#include "core/base/spelling.h"
#include "core/base/text.h"

namespace usar::posh {

namespace {

/// Takes the closing parenthesis of a part and stores the extent of the part in `whole`.
bool close(TokenCursor& cursor, const Spot& begin, std::string_view expected, Spot& whole) {
    if (!cursor.take(TokenKind::Close, expected, ")"))
        return false;
    whole = cursor.spotSince(begin);
    return true;
}

bool takeNil(TokenCursor& cursor) {
    if (cursor.keyword() != Keyword::Nil)
        return false;
    cursor.advance();
    return true;
}

bool opensUnit(const TokenCursor& cursor) {
    return cursor.at(TokenKind::Open) && unitOf(cursor.keyword(1));
}

bool opensGoal(const TokenCursor& cursor) {
    return cursor.at(TokenKind::Open) && cursor.keyword(1) == Keyword::Goal;
}

bool readOptionalGoal(TokenCursor& cursor, Senses& goal) {
    return takeNil(cursor) || !opensGoal(cursor) || readGoal(cursor, goal);
}

/// Reads the optional trigger of a drive or an element. A parenthesis after the name can only begin a trigger.
bool readTrigger(TokenCursor& cursor, Senses& trigger) {
    if (takeNil(cursor) || !cursor.at(TokenKind::Open))
        return true;
    cursor.advance();
    if (cursor.keyword() != Keyword::Trigger) {
        const std::string word = lowerCase(cursor.word());
        const bool misspelt = cursor.at(TokenKind::Name) && editDistance(word, "trigger") <= 2;
        return cursor.unexpected("the word trigger", misspelt ? "trigger" : "(trigger ((sense))) before what is done");
    }
    cursor.advance();
    return readSenses(cursor, trigger) && cursor.take(TokenKind::Close, "the end of the trigger", ")");
}

/// Reads what follows the name of a drive's action. A parenthesis there begins either arguments or the frequency; a
/// frequency may follow the arguments.
bool readDriveTail(TokenCursor& cursor, Member& drive) {
    const auto opensFrequency = [&cursor] { return opensUnit(cursor) && cursor.atNumber(2); };
    if (cursor.at(TokenKind::Open) && !opensFrequency()) {
        const bool bare = cursor.at(TokenKind::Name, 1) && !isLiteral(cursor.keyword(1));
        if (bare && cursor.atNumber(2))
            return readInterval(cursor, true, drive.frequency); // Reports the unknown unit
        if (!readArguments(cursor, drive.action.arguments))
            return false;
    }
    if (cursor.at(TokenKind::Open))
        return readInterval(cursor, true, drive.frequency);
    takeNil(cursor);
    return true;
}

bool readDrive(TokenCursor& cursor, Member& drive) {
    const Spot begin = cursor.peek().at;
    return cursor.take(TokenKind::Open, "the ( of a drive", "((name action)): drives stand in levels") &&
           readName(cursor, "of a drive", drive.name) && readTrigger(cursor, drive.trigger) &&
           readName(cursor, "of what the drive does", drive.action.name) && readDriveTail(cursor, drive) &&
           readComment(cursor, drive.comment) && close(cursor, begin, "the end of the drive", drive.at);
}

bool readRetries(TokenCursor& cursor, std::optional<Literal>& retries) {
    if (takeNil(cursor) || !cursor.atNumber())
        return true;
    if (cursor.at(TokenKind::Float))
        return cursor.fail(Code::FractionalRetries,
                           "the number of retries " + inQuotes(cursor.word()) + " is not whole; write a whole number");
    if (!readValue(cursor, retries.emplace()))
        return false;
    if (retries->value == Value(std::int64_t{0}))
        cursor.report(Code::ZeroRetries, retries->at,
                      "zero retries mean no limit here, but other readers take them as never; leave the number out");
    return true;
}

bool readElement(TokenCursor& cursor, Member& element) {
    const Spot begin = cursor.peek().at;
    return cursor.take(TokenKind::Open, "the ( of an element", "((name action)): elements stand in levels") &&
           readName(cursor, "of an element", element.name) && readTrigger(cursor, element.trigger) &&
           readCall(cursor, "of what the element does", element.action) && readRetries(cursor, element.retries) &&
           readComment(cursor, element.comment) && close(cursor, begin, "the end of the element", element.at);
}

/// Reads levels up to and including the parenthesis that closes their list.
bool readLevels(TokenCursor& cursor, Levels& levels, std::string_view expected, bool (*read)(TokenCursor&, Member&)) {
    levels.reserve(8);
    while (!cursor.at(TokenKind::Close)) {
        if (!cursor.take(TokenKind::Open, expected, "((name action))"))
            return false;
        Level& level = levels.emplace_back();
        do {
            if (!read(cursor, level.emplace_back()))
                return false;
        } while (!cursor.at(TokenKind::Close));
        cursor.advance();
    }
    cursor.advance();
    return true;
}

bool readElements(TokenCursor& cursor, Levels& levels) {
    if (!cursor.take(TokenKind::Open, "the elements", "(elements ((name action)))"))
        return false;
    const Spot keyword = cursor.peek().at;
    if (!cursor.takeKeyword(Keyword::Elements, "the word elements", "(elements ((name action)))"))
        return false;
    if (cursor.at(TokenKind::Close))
        cursor.report(Code::NoElements, keyword, "the competence has no elements; write (elements ((name action)))");
    return readLevels(cursor, levels, "a level of elements", &readElement);
}

bool readDrives(TokenCursor& cursor, Levels& levels) {
    if (!cursor.take(TokenKind::Open, "the drives", "(drives ((name action)))") ||
        !cursor.takeKeyword(Keyword::Drives, "the word drives", "(drives ((name action)))"))
        return false;
    if (cursor.at(TokenKind::Close))
        return cursor.fail(Code::EmptyList, "there are no drives; write (drives ((name action)))");
    return readLevels(cursor, levels, "a level of drives", &readDrive);
}

/// Reads a pattern's optional time limit. Only a complete `(seconds 2)` is one: otherwise `(seconds …)` is the list of
/// steps, and the first step is called "seconds".
bool readPatternTime(TokenCursor& cursor, std::optional<Interval>& limit) {
    if (takeNil(cursor) || !opensUnit(cursor))
        return true;
    const bool is_time = cursor.atNumber(2) && cursor.at(TokenKind::Close, 3);
    return !is_time || readInterval(cursor, false, limit);
}

/// Reads one step. If a parenthesis with a bare name follows the name of a step, it is the next step, a sense, and not
/// arguments.
bool readStep(TokenCursor& cursor, std::vector<Step>& steps) {
    if (cursor.at(TokenKind::Open))
        return readSenseTest(cursor, std::get<SenseTest>(steps.emplace_back(SenseTest{})));
    if (!cursor.at(TokenKind::Name))
        return cursor.unexpected("a step", "the name of an action, or (sense)");
    Call& call = std::get<Call>(steps.emplace_back());
    if (!readName(cursor, "of a step", call.name))
        return false;
    const bool next_is_sense = cursor.at(TokenKind::Name, 1) && !isLiteral(cursor.keyword(1));
    return !cursor.at(TokenKind::Open) || next_is_sense || readArguments(cursor, call.arguments);
}

bool readSteps(TokenCursor& cursor, std::vector<Step>& steps) {
    if (!cursor.take(TokenKind::Open, "the steps", "(action action)"))
        return false;
    if (cursor.at(TokenKind::Close))
        return cursor.fail(Code::EmptyList, "the pattern has no steps; write (action action)");
    while (!cursor.at(TokenKind::Close))
        if (!readStep(cursor, steps))
            return false;
    cursor.advance();
    return true;
}

} // namespace

bool readDocumentation(TokenCursor& cursor, const Spot& begin, Documentation& documentation) {
    const auto mend = "; write (documentation \"title\" \"author\" \"text\")";
    for (Literal* const part : {&documentation.title, &documentation.author, &documentation.text}) {
        if (!cursor.at(TokenKind::String))
            return cursor.fail(Code::DocumentationStrings,
                               std::string("the documentation has fewer than three strings") + mend);
        readValue(cursor, *part);
    }
    if (cursor.at(TokenKind::String))
        return cursor.fail(Code::DocumentationStrings,
                           std::string("the documentation has more than three strings") + mend);
    return close(cursor, begin, "the end of the documentation", documentation.at);
}

bool readCompetence(TokenCursor& cursor, const Spot& begin, Competence& competence) {
    if (!readName(cursor, "of the competence", competence.name) || !readFormals(cursor, competence.formals))
        return false;
    if (!takeNil(cursor) && opensUnit(cursor) && !readInterval(cursor, false, competence.time_limit))
        return false;
    return readOptionalGoal(cursor, competence.goal) && readElements(cursor, competence.levels) &&
           readComment(cursor, competence.comment) && close(cursor, begin, "the end of the competence", competence.at);
}

bool readPattern(TokenCursor& cursor, const Spot& begin, Pattern& pattern) {
    return readName(cursor, "of the pattern", pattern.name) && readFormals(cursor, pattern.formals) &&
           readPatternTime(cursor, pattern.time_limit) && readSteps(cursor, pattern.steps) &&
           readComment(cursor, pattern.comment) && close(cursor, begin, "the end of the pattern", pattern.at);
}

bool readAdopt(TokenCursor& cursor, const Spot& begin, Adopt& adopt) {
    const std::string_view mend = "(AD name ((goal ((sense))) (action)))";
    return readName(cursor, "of the adopt", adopt.name) && readFormals(cursor, adopt.formals) &&
           cursor.take(TokenKind::Open, "the ( before goal", mend) && readGoal(cursor, adopt.goal) &&
           cursor.take(TokenKind::Open, "the ( of what is adopted", mend) &&
           readCall(cursor, "of what is adopted", adopt.adopted) &&
           cursor.take(TokenKind::Close, "the end of what is adopted", ")") &&
           cursor.take(TokenKind::Close, "the end of the goal and what is adopted", ")") &&
           close(cursor, begin, "the end of the adopt", adopt.at);
}

bool readCollection(TokenCursor& cursor, const Spot& begin, Collection& collection) {
    return readName(cursor, "of the collection", collection.name) && readOptionalGoal(cursor, collection.goal) &&
           readDrives(cursor, collection.levels) && readComment(cursor, collection.comment) &&
           close(cursor, begin, "the end of the collection", collection.at);
}

} // namespace usar::posh
