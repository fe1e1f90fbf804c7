// Every error and warning about a plan in full: where it is, what is wrong and what to write.
#include <QTest>

#include <algorithm>

#include "core/posh/language/plan_reader.h"
#include "tests/suite/suite.h"

namespace tst_plan_messages {

using namespace usar;
using namespace usar::posh;

namespace {

/// Adds a row: the text of a plan and its first finding, or its first error if it has one.
void row(const char* name, const char* text, const char* message) {
    QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(message);
}

void malformedWords() {
    row("a character", "((DC d (drives ((a @)))))",
        "1:20: error E101: the character \"@\" has no meaning here; names are written with letters, digits, _ and -");
    row("an open string", "((DC d (drives ((e Stop \"why))))\n)",
        "1:25: error E102: the string is never closed; write \" at its end");
    row("an escape", R"(((DC d (drives ((e Stop "a\q"))))))",
        R"(1:27: error E103: there is no such escape; write \\ for a backslash, or one of \n \t \" \' \u0041)");
    row("a number with two points", "((AP p (1.2.3)))",
        "1:9: error E104: this is neither a number nor a name; write a number as 12, -3 or 0.5");
    row("a whole number that is too large", "((AP p ((s 99999999999999999999))))",
        "1:12: error E104: the number \"99999999999999999999\" does not fit into 64 bits; write a smaller one");
    row("a float that is too large", "((AP p ((s 1e999))))",
        "1:12: error E104: the number \"1e999\" does not fit into 64 bits; write a smaller one");
    row("a lone quote", "((AP p (a('))))",
        "1:11: error E105: a quote begins a symbol; write it as 'red or 'colors.RED");
    row("a lone dollar sign", "((AP p ($)))",
        "1:9: error E106: a dollar sign begins a variable; write its name right after it, as in $speed");
    row("a dot at the end of a name", "((AP p (a.)))",
        "1:9: error E107: this is not a name; write letters, digits, _ and -, with dots only between words");
}

void formsThatAreWrong() {
    row("no parenthesis first", "DC d", "1:1: error E201: a plan is one list of forms; write ( before \"DC\"");
    row("a drive without its level", "((DC d (drives (a b))))",
        "1:17: error E202: expected the ( of a drive, found \"a\"; write ((name action)): drives stand in levels");
    row("an element without its level", "((C k (elements (a b))))",
        "1:18: error E202: expected the ( of an element, found \"a\"; write ((name action)): elements stand in levels");
    row("a text that ends", "((DC d",
        "1:7: error E203: expected the drives, found the end of the text; write (drives ((name action))) "
        "(the parenthesis at 1:2 is open)");
    row("no text", "",
        "1:1: error E203: the text has no plan in it; write one, as ((DC name (drives ((name action)))))");
    row("only a comment", "; nothing\n\n",
        "3:1: error E203: the text has no plan in it; write one, as ((DC name (drives ((name action)))))");
    row("text after the plan", "((AP p (a))) x",
        "1:14: error E204: the plan has ended before \"x\"; remove it, or remove a ) that closes the plan too early");
    row("an unknown form", "((XP a (b)))", "1:3: error E205: \"XP\" is not a kind of form; write C, AP, AD or DC");
    row("documentation that is late", "((AP p (a)) (documentation \"\" \"\" \"\"))",
        "1:14: error E206: the documentation comes after another form; put it first in the plan");
    row("documentation with two strings", "((documentation \"a\" \"b\"))",
        "1:24: error E207: the documentation has fewer than three strings; write (documentation \"title\" \"author\" "
        "\"text\")");
    row("documentation with four strings", "((documentation \"a\" \"b\" \"c\" \"d\"))",
        "1:29: error E207: the documentation has more than three strings; write (documentation \"title\" \"author\" "
        "\"text\")");
    row("a second collection", "((DC d (drives ((a b)))) (DC e (drives ((a b)))))",
        "1:27: error E208: a plan has one drive collection and this is the second; put its drives into the first");
    row("a pattern without steps", "((AP p ()))", "1:9: error E218: the pattern has no steps; write (action action)");
    row("a collection without drives", "((DC d (drives)))",
        "1:15: error E218: there are no drives; write (drives ((name action)))");
}

void partsThatAreWrong() {
    row("an unknown unit", "((DC d (drives ((a b (second 2))))))",
        "1:23: error E209: \"second\" is not a unit; write seconds");
    row("a rate as a limit", "((C k (pm 2) (elements ((e x)))))",
        "1:8: error E209: \"pm\" is a rate and not a time limit; write none, which is a time");
    row("a unit without a number", "((C k (minutes) (elements ((e x)))))",
        "1:15: error E210: a number is missing after the unit \"minutes\"; write one, such as (minutes 2)");
    row("a negative time", "((C k (minutes -2) (elements ((e x)))))",
        "1:16: error E211: a time cannot be negative; write a number from 0 up");
    row("a rate of zero", "((DC d (drives ((a b (hz 0))))))",
        "1:26: error E211: a rate cannot be zero; write a greater number");
    row("a comparison before its value", "((AP p ((far < 3))))",
        "1:14: error E212: the comparison stands before its value; write the value first, as (far 3 <)");
    row("a word for a comparison", "((AP p ((far 3 x))))",
        "1:16: error E212: a comparison or ) must follow the value, not \"x\"; write one of == != < > <= >=, or )");
    row("a bare name as an argument", "((DC d (drives ((a act(red))))))",
        "1:24: error E213: a bare name is not a value here; write 'red for a symbol, \"red\" for a text or $red for a "
        "parameter");
    row("an argument without a name after one with", "((AP p (a($x=1, 2))))",
        "1:17: error E214: an argument without a name follows one with a name; write it before the named ones");
    row("an argument given twice", "((AP p (a($x=1, $x=2))))",
        "1:17: error E215: the argument \"$x\" is given twice; write it once");
    row("a parameter declared twice", "((AP p vars($x=1, $x=2) (a)))",
        "1:19: error E216: the parameter \"$x\" is declared twice; give the second another name");
    row("a parameter without a default", "((AP p vars($x) (a)))",
        "1:15: error E217: the parameter $x has no default; write $x=value");
    row("retries that are not whole", "((C k (elements ((e x 1.5)))))",
        "1:23: error E219: the number of retries \"1.5\" is not whole; write a whole number");
}

void plansThatAreWrong() {
    row("a name used twice", "((AP p (a)) (AP p (b)))",
        "1:17: error E301: the name \"p\" is already used at 1:6; give this one another name");
    row("a pattern in itself", "((AP p (p)))", "1:9: error E302: \"p\" contains itself; call something else here");
    row("a variable of nobody", "((AP p (a($x))))",
        "1:11: error E306: \"$x\" is not a parameter of this form; declare it with vars($name=value)");
    row("a variable among the drives", "((DC d (drives ((a b($x))))))",
        "1:22: error E306: \"$x\" has no value here: a collection has no parameters; write a value");
}

void plansThatAreOdd() {
    row("a bad byte", "( ; \xFF\n (DC d (drives ((a act)))))",
        "1:5: warning W400: this byte is not valid UTF-8 and is read as U+FFFD; save the file as UTF-8");
    row("a fragment", "((AP p (a)))",
        "1:6: warning W401: the plan has no drive collection and cannot run; add (DC name (drives ((name action))))");
    row("a drive's name twice", "((DC d (drives ((a (trigger ((s))) x)) ((a y)))))",
        "1:42: warning W402: the name \"a\" is used twice here; give one of the two another name");
    row("a form that nothing calls", "((AP p (a))\n (DC d (drives ((a act)))))",
        "1:6: warning W404: \"p\" is never used; call it, or remove it");
    row("an odd space", "(\xC2\xA0(DC d (drives ((a act)))))",
        "1:2: warning W405: this is not an ordinary space, though it looks like one; write a space");
    row("a digit first", "((DC d (drives ((a 3act)))))",
        "1:20: warning W406: the name starts with a digit, which other readers refuse; begin it with a letter");
    row("a keyword as a name", "((DC goal (drives ((a b)))))",
        "1:6: warning W407: \"goal\" is a word of the language and is read as a name here; choose another");
    row("a built-in sense with another name", "((DC d (drives ((a (trigger ((true))) b)))))",
        "1:31: warning W407: \"true\" is a word of the language and is read as a name here; write succeed");
    row("no elements", "((C k (elements))\n (DC d (drives ((a k)))))",
        "1:8: warning W408: the competence has no elements; write (elements ((name action)))");
    row("zero retries", "((C k (elements ((e act 0))))\n (DC d (drives ((a k)))))",
        "1:25: warning W409: zero retries mean no limit here, but other readers take them as never; leave the number "
        "out");
    row("a drive that is never reached", "((DC d (drives ((a x)) ((b y)))))",
        "1:26: warning W410: \"b\" is never reached: \"a\" before it is always ready; give that a trigger, or move it "
        "to the end");
    row("a competence that may find nothing", "((C k (elements ((e (trigger ((s))) x))))\n (DC d (drives ((a k)))))",
        "1:5: warning W411: no element of \"k\" may be ready; add a last one without a trigger, or a goal");
    row("an argument too many", "((AP p (a))\n (DC d (drives ((a p(1))))))",
        "2:22: warning W412: \"p\" has fewer parameters, so this argument is ignored; leave it out, or declare it");
    row("an argument that is not declared", "((AP p (a))\n (DC d (drives ((a p($y=3))))))",
        "2:22: warning W412: \"p\" declares no \"$y\", which is passed down; declare it, or correct the name");
}

} // namespace

class tst_PlanMessages : public QObject {
    Q_OBJECT
private slots:
    void aFindingSaysWhereWhatAndHow_data();
    void aFindingSaysWhereWhatAndHow();
    void wordsAreQuotedBriefly_data();
    void wordsAreQuotedBriefly();
    void severityFollowsFromTheCode();
    void aTextBeyondTheLimitIsRefused();
};

void tst_PlanMessages::aFindingSaysWhereWhatAndHow_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    malformedWords();
    formsThatAreWrong();
    partsThatAreWrong();
    plansThatAreWrong();
    plansThatAreOdd();
}

void tst_PlanMessages::aFindingSaysWhereWhatAndHow() {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    const Findings findings = readPlan(text.toStdString()).findings;
    QVERIFY(!findings.empty());
    const auto error =
        std::ranges::find(findings, Severity::Error, [](const Finding& f) { return severityOf(f.code); });
    QCOMPARE(QString::fromStdString(toText(error == findings.end() ? findings.front() : *error)), message);
}

void tst_PlanMessages::wordsAreQuotedBriefly_data() {
    QTest::addColumn<QByteArray>("word");
    QTest::addColumn<QByteArray>("quoted");
    QTest::newRow("empty") << QByteArray() << QByteArray("\"\"");
    QTest::newRow("short") << QByteArray("fly") << QByteArray("\"fly\"");
    QTest::newRow("forty bytes") << QByteArray(40, 'x') << '"' + QByteArray(40, 'x') + '"';
    QTest::newRow("forty-one bytes") << QByteArray(41, 'x') << '"' + QByteArray(40, 'x') + "\xE2\x80\xA6\"";
    QTest::newRow("a character across the limit")
        << QByteArray(39, 'x') + "\xC3\xA9" << '"' + QByteArray(39, 'x') + "\xC3\xA9\"";
    QTest::newRow("line end and tab") << QByteArray("a\n\tb") << QByteArray("\"a  b\"");
    QTest::newRow("a bad byte") << QByteArray("a\xFF") << QByteArray("\"a\xEF\xBF\xBD\"");
}

void tst_PlanMessages::wordsAreQuotedBriefly() {
    QFETCH(QByteArray, word);
    QFETCH(QByteArray, quoted);
    QCOMPARE(QByteArray::fromStdString(inQuotes(word.toStdString())), quoted);
}

void tst_PlanMessages::severityFollowsFromTheCode() {
    QCOMPARE(toText(Code::IllegalCharacter), std::string("E101"));
    QCOMPARE(toText(Code::WrongUse), std::string("E307"));
    QCOMPARE(toText(Code::BadByte), std::string("W400"));
    QVERIFY(isUnreadable(Code::FractionalRetries) && !isUnreadable(Code::DuplicateName));
    const Findings warning{{Code::NeverUsed, {}, "", {}}};
    const Findings error{{Code::NeverUsed, {}, "", {}}, {Code::FreeVariable, {}, "", {}}};
    const Findings unreadable{{Code::FreeVariable, {}, "", {}}, {Code::EndOfFile, {}, "", {}}};
    QVERIFY(!hasErrors({}) && !hasErrors(warning) && hasErrors(error) && hasErrors(unreadable));
    QVERIFY(isReadable({}) && isReadable(warning) && isReadable(error) && !isReadable(unreadable));
}

void tst_PlanMessages::aTextBeyondTheLimitIsRefused() {
    const PlanReading reading = readPlan(std::string((std::size_t{64} << 20U) + 1, ' '));
    QCOMPARE(reading.findings.size(), std::size_t(1));
    QCOMPARE(toText(reading.findings.front()),
             std::string("1:1: error E201: the text is longer than 64 MiB, the limit for a plan; give another file"));
    QVERIFY(reading.plan == Plan());
}

USAR_TEST(tst_PlanMessages)

} // namespace tst_plan_messages

#include "tst_plan_messages.moc"
