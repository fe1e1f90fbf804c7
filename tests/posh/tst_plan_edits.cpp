// Edits of a plan's text: each does what it says, keeps what it does not touch, and never leaves a text that cannot be
// read.
#include <QTest>

#include <algorithm>
#include <functional>

#include "core/posh/edit/plan_edits.h"
#include "core/posh/edit/plan_phrase.h"
#include "core/posh/edit/plan_templates.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/run/program.h"
#include "tests/suite/suite.h"

namespace tst_plan_edits {

using namespace usar;
using namespace usar::posh;

namespace {

using Edit = std::function<Result<PlanEdit>()>;

const std::string source = "; mine\n(\n"
                           "  ;; picks it up\n"
                           "  (C pick (goal ((holding))) ; header\n"
                           "    (elements\n"
                           "      ; when near\n"
                           "      ((grab  (trigger ((near) (calm))) close 3)) ; quick\n"
                           "      ((look  (trigger ((lost)))        turn))\n"
                           "      ((go    drive(2.5)))))\n"
                           "  (AP wave   (up   down up))  ; by hand\n"
                           "  (AD rest vars($long=3) ((goal ((rested))) (sleep($long))))\n"
                           "  (DC me\n"
                           "    (drives\n"
                           "      ((safe  (trigger ((bumped))) wave (seconds 2)))\n"
                           "      ( (work (trigger ((near)))   pick)\n"
                           "        (play (trigger ((calm)))   wave))\n"
                           "      ((idle  rest)))))\n";

/// Of the n-th place where the words stand in the source.
std::size_t offsetOf(const std::string& words, int n = 1) {
    std::size_t at = source.find(words);
    while (--n > 0 && at != std::string::npos)
        at = source.find(words, at + 1);
    return at;
}

PlanPart part(const std::string& words, int n = 1) {
    const auto found = partAt(readPlan(source).plan, offsetOf(words, n));
    return found ? *found : PlanPart{PartKind::Whole, 99};
}

Call call(const std::string& words) {
    return readCallPhrase(words).value();
}

Senses senses(const std::string& words) {
    return readSensesPhrase(words).value();
}

/// The source with the first `old` replaced, and the next pair in what comes out.
std::string with(std::string text, std::initializer_list<std::pair<std::string, std::string>> changes) {
    for (const auto& [old, wanted] : changes) {
        const std::size_t at = text.find(old);
        if (at == std::string::npos)
            return "there is no " + old;
        text.replace(at, old.size(), wanted);
    }
    return text;
}

/// Adds a row: what is edited, how, and the changes of the source that this makes.
void row(const char* name, Edit edit, std::initializer_list<std::pair<std::string, std::string>> changes) {
    QTest::newRow(name) << std::move(edit) << QString::fromStdString(with(source, changes));
}

void namesAndSwaps() {
    row("a pattern with its calls is renamed", [] { return renamePart(source, part("wave"), "greet"); },
        {{"AP wave", "AP greet"}, {"wave (sec", "greet (sec"}, {"  wave))", "  greet))"}});
    row("a call renames its form", [] { return renamePart(source, part("pick)"), "take"); },
        {{"C pick", "C take"}, {" pick)", " take)"}});
    row("a sense is renamed in goals and triggers", [] { return renamePart(source, part("near) (calm"), "by.close"); },
        {{"((near) (", "((by.close) ("}, {"((near))", "((by.close))"}});
    row("an act is renamed", [] { return renamePart(source, part("up   "), "rise"); },
        {{"(up ", "(rise "}, {"down up", "down rise"}});
    row("a drive is renamed", [] { return renamePart(source, part("safe"), "rescue"); }, {{"(safe ", "(rescue "}});
    row("two acts change places", [] { return swapParts(source, part("turn"), part("drive(")); },
        {{" turn))", " drive(2.5)))"}, {"(go    drive(2.5))", "(go    turn)"}});
    row("two references change places", [] { return swapParts(source, part("wave (sec"), part("rest)))")); },
        {{"wave (sec", "rest (sec"}, {"idle  rest)", "idle  wave)"}});
    row("two senses change places", [] { return swapParts(source, part("near) (c"), part("lost")); },
        {{"((near) (calm))", "((lost) (calm))"}, {"(lost)))   ", "(near)))   "}});
    row("two elements change places", [] { return swapParts(source, part("look"), part("go  ")); },
        {{"      ((look  (trigger ((lost)))        turn))\n      ((go    drive(2.5)))))",
          "      ((go    drive(2.5)))\n      ((look  (trigger ((lost)))        turn))))"}});
}

void moves() {
    row("an element goes up with its comments", [] { return shiftPart(source, part("look"), -1); },
        {{"      ; when near\n      ((grab  (trigger ((near) (calm))) close 3)) ; quick\n"
          "      ((look  (trigger ((lost)))        turn))\n",
          "      ((look  (trigger ((lost)))        turn))\n"
          "      ; when near\n      ((grab  (trigger ((near) (calm))) close 3)) ; quick\n"}});
    row("a step goes down", [] { return shiftPart(source, part("up   "), 1); }, {{"up   down up", "down up up"}});
    row("a sense goes up", [] { return shiftPart(source, part("calm)))"), -1); },
        {{"((near) (calm))", "((calm) (near))"}});
    row("an equal gets a level of its own", [] { return shiftPart(source, part("play"), 1); },
        {{"      ( (work (trigger ((near)))   pick)\n        (play (trigger ((calm)))   wave))\n",
          "      ((work (trigger ((near))) pick))\n      ((play (trigger ((calm))) wave))\n"}});
    row("a drive joins the level above", [] { return joinLevel(source, part("idle"), -1); },
        {{"      ( (work (trigger ((near)))   pick)\n        (play (trigger ((calm)))   wave))\n      ((idle  rest))",
          "      ( (work (trigger ((near))) pick)\n        (play (trigger ((calm))) wave)\n        (idle rest))"}});
}

void additions() {
    row("a drive is added with a trigger",
        [] {
            return addMember(source, {3, 0}, call("flee(1)"), senses("(fire)"));
        },
        {{"(drives\n", "(drives\n      ((flee  (trigger ((fire))) flee(1)))\n"}});
    row("an added element gets a free name",
        [] {
            return addMember(source, {0, 3}, call("go"), {});
        },
        {{"drive(2.5)))))", "drive(2.5)))\n      ((go-2 go))))"}});
    row("a step is added", [] { return addStep(source, 1, 1, call("left")); }, {{"up   down up", "up left   down up"}});
    row("a sense is added to a trigger",
        [] { return addSense(source, part("look"), readSensePhrase("x 3 <").value()); },
        {{"((lost))", "((lost) (x 3 <))"}});
    row("a pattern is added before the drives", [] { return addForm(source, FormKind::Ap, "hop", call("jump")); },
        {{"  (DC me", "  (AP hop (jump))\n  (DC me"}});
}

void removalsAndValues() {
    row("an element is taken away with its comments", [] { return removePart(source, part("grab")); },
        {{"      ; when near\n      ((grab  (trigger ((near) (calm))) close 3)) ; quick\n", ""}});
    row("what is done becomes nothing", [] { return removePart(source, part("turn")); }, {{"turn", "doNothing"}});
    row("a sense is taken away", [] { return removePart(source, part("near) (calm")); },
        {{"((near) (calm))", "((calm))"}});
    row("a call is put in place of another", [] { return replaceCall(source, part("turn"), call("wave")); },
        {{"turn", "wave"}});
    row("a sense gets a value",
        [] { return replaceSense(source, part("lost"), readSensePhrase("lost 2.0 >").value()); },
        {{"((lost))", "((lost 2.0 >))"}});
    row("a trigger is taken away", [] { return setSenses(source, part("look"), {}); },
        {{"(trigger ((lost)))        turn", "      turn"}});
    row("a goal is set", [] { return setSenses(source, part("me\n"), senses("(over)")); },
        {{"(DC me", "(DC me (goal ((over)))"}});
    row("a frequency is set", [] { return setLimit(source, part("safe"), "hz 5"); }, {{"seconds 2", "hz 5"}});
    row("retries are taken away", [] { return setLimit(source, part("grab"), ""); }, {{"close 3", "close"}});
    row("a time is set", [] { return setLimit(source, part("wave"), "minutes 1"); },
        {{"wave   (", "wave (minutes 1)   ("}});
    row("a comment is written", [] { return setComment(source, part("look"), "a \"b\""); },
        {{"turn)", "turn \"a \\\"b\\\"\")"}});
}

void wraps() {
    row("an act is wrapped in a competence", [] { return wrapCall(source, part("turn"), FormKind::C); },
        {{"  ;; picks it up\n", "  (C choose-turn\n    (elements\n      ((turn turn))))\n  ;; picks it up\n"},
         {"        turn))", "        choose-turn))"}});
    row("what is wrapped keeps its parameters", [] { return wrapCall(source, part("sleep"), FormKind::Ap); },
        {{"  (AD rest", "  (AP do-sleep vars($long=3) (sleep($long)))\n  (AD rest"},
         {"((rested))) (sleep($long)", "((rested))) (do-sleep($long=$long)"}});
    row("two steps are wrapped in a pattern",
        [] { return wrapParts(source, part("down up"), part("up   down"), FormKind::Ap); },
        {{"  (AP wave   (up   down up)", "  (AP do-up (up down))\n  (AP wave   (do-up up)"}});
    row("two elements are wrapped in a competence",
        [] { return wrapParts(source, part("look"), part("go "), FormKind::C, "search"); },
        {{"  ;; picks it up\n", "  (C search\n    (elements\n      ((look (trigger ((lost))) turn))\n      ((go   "
                                "drive(2.5)))))\n  ;; picks it up\n"},
         {"      ((look  (trigger ((lost)))        turn))\n      ((go    drive(2.5)))))",
          "      ((search search))))"}});
    row("a drive is duplicated", [] { return duplicatePart(source, part("idle")); },
        {{"((idle  rest))", "((idle  rest))\n      ((idle-2 rest))"}});
}

} // namespace

class tst_PlanEdits : public QObject {
    Q_OBJECT
private slots:
    void anEditDoesWhatItSays_data();
    void anEditDoesWhatItSays();
    void whatCannotBeIsRefusedWithAReason_data();
    void whatCannotBeIsRefusedWithAReason();
    void partsAreFoundByTheirPlace();
    void usagesAreAllCallsOfAForm();
    void swappingTwiceIsNothing();
    void aTextWithErrorsIsNotTouched();
    void anErrorOfThePlanKeepsTheLayout();
    void phrasesAreOnePartOnly_data();
    void phrasesAreOnePartOnly();
    void templatesAreSoundAndRunAtOnce();
};

void tst_PlanEdits::anEditDoesWhatItSays_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QString>("expected");
    namesAndSwaps();
    moves();
    additions();
    removalsAndValues();
    wraps();
}

void tst_PlanEdits::anEditDoesWhatItSays() {
    QFETCH(Edit, edit);
    QFETCH(QString, expected);
    const auto edited = edit();
    QVERIFY2(edited.has_value(), edited ? "" : edited.error().text().c_str());
    const QStringList got = QString::fromStdString(edited->text).split('\n');
    const QStringList wanted = expected.split('\n');
    for (int i = 0; i < std::min(got.size(), wanted.size()); ++i)
        QCOMPARE(got[i], wanted[i]);
    QCOMPARE(got.size(), wanted.size());
    QVERIFY(nameOf(readPlan(edited->text).plan, edited->part));
}

void tst_PlanEdits::whatCannotBeIsRefusedWithAReason_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const char* reason, Edit edit) {
        QTest::newRow(name) << std::move(edit) << QString::fromUtf8(reason);
    };
    row("a name that is taken", "taken by the competence", [] { return renamePart(source, part("wave"), "pick"); });
    row("a name that an act has", "taken by the act", [] { return renamePart(source, part("wave"), "turn"); });
    row("an act that would become a call", "has this name", [] { return renamePart(source, part("turn"), "wave"); });
    row("a name beside its like", "has this name", [] { return renamePart(source, part("look"), "go"); });
    row("a name with a blank", "not a name", [] { return renamePart(source, part("wave"), "a b"); });
    row("a word of the language", "word of the language", [] { return renamePart(source, part("wave"), "Trigger"); });
    row("no name", "not a name", [] { return renamePart(source, part("wave"), ""); });
    row("a circle of references", "E302", [] { return replaceCall(source, part("turn"), call("pick")); });
    row("a parameter that is not declared", "E306", [] { return replaceCall(source, part("turn"), call("x($y)")); });
    row("a sense and an act", "different kinds", [] { return swapParts(source, part("lost"), part("turn")); });
    row("a drive and an element", "cannot be swapped", [] { return swapParts(source, part("look"), part("idle")); });
    row("a form that is called", "called in line 14, 16", [] { return removePart(source, part("wave")); });
    row("the first goes no farther up", "already the first", [] { return shiftPart(source, part("grab"), -1); });
    row("the last goes no farther down", "already the last", [] { return shiftPart(source, part("idle"), 1); });
    row("a drive with a frequency into a competence", "frequency", [] {
        return moveMember(source, part("safe"), {0, 0});
    });
    row("an element with retries among the drives", "retries", [] { return moveMember(source, part("grab"), {3, 0}); });
    row("a limit that is none", "often", [] { return setLimit(source, part("look"), "often"); });
    row("a second collection", "one drive coll", [] { return addForm(source, FormKind::Dc, "two", call("x")); });
    row("a part that is not there", "no such part", [] { return removePart(source, {PartKind::Whole, 77}); });
    row("steps in a competence", "in an action pattern",
        [] { return wrapParts(source, part("up   down"), part("down"), FormKind::C); });
    row("elements in a pattern", "in a competence",
        [] { return wrapParts(source, part("look"), part("go "), FormKind::Ap); });
    row("a drive with a frequency in a competence", "frequency",
        [] { return wrapParts(source, part("safe"), part("idle"), FormKind::C); });
    row("parts of two forms", "no such part",
        [] { return wrapParts(source, part("look"), part("down"), FormKind::Ap); });
    row("more than can stand there", "more than fits here", [] { return inlineCall(source, part("pick)")); });
}

void tst_PlanEdits::whatCannotBeIsRefusedWithAReason() {
    QFETCH(Edit, edit);
    QFETCH(QString, reason);
    const auto edited = edit();
    QVERIFY(!edited.has_value());
    const QString said = QString::fromStdString(edited.error().text());
    QVERIFY2(said.contains(reason), qPrintable(said));
}

void tst_PlanEdits::partsAreFoundByTheirPlace() {
    const Plan plan = readPlan(source).plan;
    QCOMPARE(part("grab"), memberPart(0, 0, 0));
    QCOMPARE(part("3)) ;"), memberPart(0, 0, 0)); // what is in it and has no name
    QCOMPARE(part("close"), actionPart(0, 0, 0));
    QCOMPARE(part("calm)))   wave").kind, PartKind::Sense);
    QCOMPARE(part("holding"), (PlanPart{PartKind::Sense, 0}));
    QCOMPARE(part("down"), (PlanPart{PartKind::Action, 1, 0, 0, 1}));
    QVERIFY(isStep(plan, part("down")) && !isStep(plan, part("close")));
    QVERIFY(!partAt(plan, 0));
    QCOMPARE(describe(plan, part("bumped")), std::string("the sense \"bumped\""));
}

void tst_PlanEdits::usagesAreAllCallsOfAForm() {
    const Plan plan = readPlan(source).plan;
    QCOMPARE(usagesOf(plan, part("wave")).size(), std::size_t(3));
    QCOMPARE(usagesOf(plan, part("wave (sec")), usagesOf(plan, part("wave")));
    QCOMPARE(usagesOf(plan, part("near")).size(), std::size_t(2));
    QCOMPARE(usagesOf(plan, part("safe")).size(), std::size_t(1));
    QCOMPARE(usagesOf(plan, part("me\n")).size(), std::size_t(1));
}

void tst_PlanEdits::swappingTwiceIsNothing() {
    for (const auto& [a, b] : {std::pair(part("grab"), part("go  ")), std::pair(part("turn"), part("drive(")),
                               std::pair(part("wave"), part("pick (")), std::pair(part("up "), part("down"))}) {
        const auto once = swapParts(source, a, b);
        QVERIFY(once && once->text != source);
        const auto twice = swapParts(once->text, a, b);
        QVERIFY(twice && readPlan(twice->text).plan == readPlan(source).plan);
    }
}

void tst_PlanEdits::aTextWithErrorsIsNotTouched() {
    const std::string broken = "((AP a (b))\n (AP c ())\n (DC d (drives ((e a)))))";
    const auto edited = renamePart(broken, formPart(0), "fresh");
    QVERIFY(!edited);
    QVERIFY2(edited.error().text().find("line 2") != std::string::npos, edited.error().text().c_str());
}

void tst_PlanEdits::anErrorOfThePlanKeepsTheLayout() {
    const std::string doubled = with(source, {{"AP wave   (up", "AP pick   (up"}});
    const auto edited = setLimit(doubled, part("look"), "4");
    QVERIFY(edited);
    QCOMPARE(QString::fromStdString(edited->text), QString::fromStdString(with(doubled, {{"turn", "turn 4"}})));
}

void tst_PlanEdits::phrasesAreOnePartOnly_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("sense");
    QTest::addColumn<bool>("call");
    QTest::newRow("a name") << "fly" << true << true;
    QTest::newRow("with arguments") << "fly(2, $at=\"x\")" << true << true;
    QTest::newRow("with a value") << "fly 2 <" << true << false;
    QTest::newRow("in parentheses") << "(fly 2 <)" << true << false;
    QTest::newRow("with retries") << "fly 2" << true << false;
    QTest::newRow("two") << "fly land" << true << false; // a sense with a symbol
    QTest::newRow("a way out") << "a))) ((b c" << false << false;
    QTest::newRow("another way out") << "a)) (e2 (trigger ((b)" << false << false;
    QTest::newRow("a comment") << "a ; b" << false << false;
    QTest::newRow("nothing") << "" << false << false;
    QTest::newRow("a number") << "3" << false << false;
}

void tst_PlanEdits::phrasesAreOnePartOnly() {
    QFETCH(QString, words);
    QTEST(readSensePhrase(words.toStdString()).has_value(), "sense");
    QTEST(readCallPhrase(words.toStdString()).has_value(), "call");
}

void tst_PlanEdits::templatesAreSoundAndRunAtOnce() {
    for (const PlanTemplate& pattern : planTemplates()) {
        const PlanReading reading = readPlan(pattern.text);
        QVERIFY2(reading.findings.empty(), pattern.title.c_str());
        QVERIFY(compile(reading.plan).has_value());
        for (const NamedPart& named : partsOf(reading.plan))
            if (named.part.kind == PartKind::Action || named.part.kind == PartKind::Sense) {
                const std::string& name = named.name->text;
                const bool is_form = usagesOf(reading.plan, named.part).front().kind == PartKind::Whole;
                QVERIFY2(is_form || name == "doNothing" || name == "fail" || name == "succeed", name.c_str());
            }
    }
}

USAR_TEST(tst_PlanEdits)

} // namespace tst_plan_edits

#include "tst_plan_edits.moc"
