// Mends of what is wrong: each is put into the text, and then the finding is gone.
#include <QTest>

#include <algorithm>

#include "core/base/random.h"
#include "core/posh/edit/plan_part.h"
#include "core/posh/edit/quick_fixes.h"
#include "core/posh/language/plan_reader.h"
#include "plan_corpus.h"
#include "tests/suite/suite.h"

namespace tst_quick_fixes {

using namespace usar;
using namespace usar::posh;

namespace {

const Vocabulary robot{{"Bumped", "Battery", "Near"}, {"Stop", "Drive", "Beep"}};

/// A binding to the robot above: unknown names and misused ones.
Findings bind(std::string_view text) {
    PlanReading reading = readPlan(text);
    Findings findings = std::move(reading.findings);
    const auto knows = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!collectionOf(reading.plan))
        findings.push_back({Code::NoCollection, {}, "no drives", {}});
    for (const NamedPart& named : partsOf(reading.plan)) {
        const std::string& name = named.name->text;
        const bool is_sense = named.part.kind == PartKind::Sense;
        if (named.part.kind == PartKind::Whole && (knows(robot.acts, name) || knows(robot.senses, name)))
            findings.push_back({Code::PrimitiveNamedAsForm, named.name->at, name + " is of the robot", {}});
        if (named.part.kind != PartKind::Action && !is_sense)
            continue;
        const bool is_form = usagesOf(reading.plan, named.part).front().kind == PartKind::Whole;
        if (is_form || name == "doNothing" || name == "fail")
            continue;
        if (knows(is_sense ? robot.acts : robot.senses, name))
            findings.push_back({Code::WrongUse, named.name->at, name + " is no such thing", {}});
        else if (!knows(is_sense ? robot.senses : robot.acts, name))
            findings.push_back({Code::UnknownPrimitive, named.name->at, "there is no " + name, {}});
        else if (!callOf(reading.plan, named.part)->arguments.empty())
            findings.push_back({Code::WrongUse, named.name->at, name + " takes no arguments", {}});
    }
    return findings;
}

/// A plan whose one drive does that.
std::string doing(const std::string& act) {
    return "((DC d (drives ((e " + act + ")))))";
}

/// A plan whose one drive calls the form of that name.
std::string calling(const std::string& name, const std::string& forms) {
    return "(" + forms + " (DC d (drives ((e " + name + ")))))";
}

const Finding* findingOf(const Findings& findings, const std::string& code) {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&code](const Finding& f) { return toText(f.code) == code; });
    return found == findings.end() ? nullptr : &*found;
}

std::string titlesOf(const std::vector<QuickFix>& fixes) {
    std::string titles;
    for (const QuickFix& fix : fixes)
        titles += fix.title + '\n';
    return titles;
}

/// Adds a row: the code of a finding in a text, the start of the fix's title, and the text after it (empty if any).
void row(const char* name, const char* code, const std::string& text, const char* title, const std::string& expected) {
    QTest::newRow(name) << QString::fromStdString(text) << QString::fromUtf8(code) << QString::fromUtf8(title)
                        << QString::fromStdString(expected);
}

void textsThatDoNotParse() {
    row("illegal character", "E101", doing("St@op"), "Remove \"@\"", doing("Stop"));
    row("open string", "E102", "((DC d (drives ((e Stop \"why))))\n)", "Close the string before the parentheses",
        "((DC d (drives ((e Stop \"why\"))))\n)");
    row("unknown escape", "E103", doing("Stop \"a\\q\""), "Write a backslash", doing("Stop \"a\\\\q\""));
    row("malformed number", "E104", calling("c", "(C c (minutes 1.2.3) (elements ((e Stop))))"), "Write 1.2",
        calling("c", "(C c (minutes 1.2) (elements ((e Stop))))"));
    row("quote without symbol", "E105", doing("(trigger ((Near ' ==))) Stop"), "Remove \"'\"", "");
    row("malformed name", "E107", doing("Stop."), "Write Stop", doing("Stop"));
    row("no parenthesis first", "E201", "DC d (drives ((e Stop)))", "Put parentheses", "");
    row("misspelt trigger", "E202", doing("(triger ((Near))) Stop"), "Write trigger", doing("(trigger ((Near))) Stop"));
    row("no level", "E202", "((DC d (drives (e Stop))))", "Put parentheses around it", doing("Stop"));
    row("a trigger without its list", "E202", doing("(trigger (Near 3 <)) Stop"), "Put parentheses around it",
        doing("(trigger ((Near 3 <))) Stop"));
    row("not closed at the end", "E203", "((DC d (drives ((e Stop)", "Close 4 parentheses at the end", doing("Stop"));
    row("a form not closed", "E202", "(\n (AP a (Stop)\n (DC d (drives ((e a))))\n)", "Close a parenthesis before",
        "(\n (AP a (Stop))\n (DC d (drives ((e a))))\n)");
    row("one too many at the end", "E204", "((DC d (drives ((e Stop))))))", "Remove \")\"", doing("Stop"));
    row("closed too early", "E204", "((AP a (Stop)))\n (DC d (drives ((e a)))))", "Remove the ) before it",
        "((AP a (Stop))\n (DC d (drives ((e a)))))");
    row("unknown form", "E205", calling("a", "(XP a (Stop))"), "Write AP", calling("a", "(AP a (Stop))"));
    row("late documentation", "E206", "((DC d (drives ((e Stop)))) (documentation \"a\" \"b\" \"c\"))",
        "Move it to the front", "(\n  (documentation \"a\" \"b\" \"c\")(DC d (drives ((e Stop)))) )");
    row("two strings of documentation", "E207", calling("Stop", "(documentation \"a\" \"b\")"), "Write empty texts",
        calling("Stop", "(documentation \"a\" \"b\" \"\")"));
    row("four strings", "E207", calling("Stop", "(documentation \"a\" \"b\" \"c\" \"d\")"), "Remove",
        calling("Stop", "(documentation \"a\" \"b\" \"c\")"));
    row("second collection", "E208", "((DC d (drives ((e Stop)))) (DC f (drives ((e Stop)))))", "Remove",
        doing("Stop"));
}

void partsThatAreWrong() {
    row("unknown unit", "E209", doing("Stop (sec 2)"), "Write seconds", doing("Stop (seconds 2)"));
    row("no number", "E210", calling("c", "(C c (minutes) (elements ((e Stop))))"), "Write 1",
        calling("c", "(C c (minutes 1) (elements ((e Stop))))"));
    row("negative number", "E211", calling("c", "(C c (minutes -2) (elements ((e Stop))))"), "Write 2",
        calling("c", "(C c (minutes 2) (elements ((e Stop))))"));
    row("predicate first", "E212", doing("(trigger ((Near < 3))) Stop"), "Write 3 <",
        doing("(trigger ((Near 3 <))) Stop"));
    row("bare name as a value", "E213", doing("Stop(fast)"), "Write 'fast", doing("Stop('fast)"));
    row("positional after named", "E214", calling("a", "(AP a (Stop($x=1, 2)))"), "Move it to the front",
        calling("a", "(AP a (Stop(2, $x=1)))"));
    row("argument twice", "E215", calling("a", "(AP a (Stop($x=1, $x=2)))"), "Remove the argument",
        calling("a", "(AP a (Stop($x=1)))"));
    row("parameter twice", "E216", calling("a", "(AP a vars($x=1, $x=2) (Stop))"), "Remove the second",
        calling("a", "(AP a vars($x=1) (Stop))"));
    row("parameter without default", "E217", calling("a", "(AP a vars($x) (Stop))"), "Give it the value 0",
        calling("a", "(AP a vars($x=0) (Stop))"));
    row("no steps", "E218", calling("a", "(AP a ())"), "Add a step", calling("a", "(AP a (doNothing))"));
    row("no drives", "E218", "((DC d (drives)))", "Add a drive", "((DC d (drives ((idle doNothing)))))");
    row("half a start", "E219", calling("c", "(C c (elements ((e Stop 2.7))))"), "Write 3",
        calling("c", "(C c (elements ((e Stop 3))))"));
}

void plansThatCannotRun() {
    row("name twice", "E301", calling("a", "(AP a (Stop)) (AP a (Beep))"), "Name it a-2",
        calling("a", "(AP a (Stop)) (AP a-2 (Beep))"));
    row("circle", "E302", calling("a", "(AP a (a))"), "Do nothing here", calling("a", "(AP a (doNothing))"));
    row("no collection", "E303", "((AP a (Stop)))", "Add a drive collection", "");
    row("unknown act", "E304", doing("Dirve"), "Write Drive", doing("Drive"));
    row("an act begun", "E304", doing("Dr"), "Write Drive", doing("Drive"));
    row("unknown act everywhere", "E304", calling("a", "(AP a (Stpo Stpo))"), "Write Stop everywhere", "");
    row("an act to be made", "E304", doing("dance"), "Make a pattern dance", "");
    row("unknown sense", "E304", doing("(trigger ((bumpd))) Stop"), "Write Bumped", doing("(trigger ((Bumped))) Stop"));
    row("form named as an act", "E305", calling("Stop", "(AP Stop (Beep))"), "Name it Stop-plan",
        calling("Stop-plan", "(AP Stop-plan (Beep))"));
    row("unknown parameter", "E306", calling("a", "(AP a vars($speed=1) (x($sped)))"), "Write $speed",
        calling("a", "(AP a vars($speed=1) (x($speed)))"));
    row("parameter to declare", "E306", calling("a", "(AP a (x($y)))"), "Declare $y",
        calling("a", "(AP a vars($y=0) (x($y)))"));
    row("arguments that it does not take", "E307", doing("Stop(3)"), "Remove the arguments", doing("Stop"));
    row("a sense done", "E307", doing("Near"), "Write Beep", "");
}

void likelyMistakes() {
    row("fragment", "W401", "((AP a (Stop)))", "Add a drive collection", "");
    row("drive twice", "W402", "((DC d (drives ((e (trigger ((Near))) Stop)) ((e Stop)))))", "Name it e-2",
        "((DC d (drives ((e (trigger ((Near))) Stop)) ((e-2 Stop)))))");
    row("never used", "W404", calling("Stop", "(AP a (Stop))"), "Remove it", "");
    row("odd blank", "W405", "((DC d (drives ((e\xc2\xa0Stop)))))", "Write an ordinary blank", doing("Stop"));
    row("name with a digit first", "W406", calling("3a", "(AP 3a (Stop))"), "Name it n3a",
        calling("n3a", "(AP n3a (Stop))"));
    row("word of the language", "W407", calling("goal", "(AP goal (Stop))"), "Name it my-goal",
        calling("my-goal", "(AP my-goal (Stop))"));
    row("no elements", "W408", calling("c", "(C c (elements))"), "Add an element", "");
    row("zero starts", "W409", calling("c", "(C c (elements ((e Stop 0))))"), "Remove the number",
        calling("c", "(C c (elements ((e Stop))))"));
    row("never reached", "W410", "((DC d (drives ((e Stop)) ((f (trigger ((Near))) Beep)))))", "Move \"e\" to the end",
        "");
    row("may find nothing", "W411", calling("c", "(C c (elements ((e (trigger ((Near))) Stop))))"),
        "Add a last element", "");
    row("argument too many", "W412", "((AP a (Stop)) (DC d (drives ((e a(3))))))", "Remove the argument",
        calling("a", "(AP a (Stop))"));
}

} // namespace

class tst_QuickFixes : public QObject {
    Q_OBJECT
private slots:
    void aFixIsOfferedAndHelps_data();
    void aFixIsOfferedAndHelps();
    void everyOfferedFixHelps();
    void mendsOfDamagedTextsAreInOrderAndHelp();
    void differenceIsShortAndWhole_data();
    void differenceIsShortAndWhole();
};

void tst_QuickFixes::aFixIsOfferedAndHelps_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("title");
    QTest::addColumn<QString>("expected");
    textsThatDoNotParse();
    partsThatAreWrong();
    plansThatCannotRun();
    likelyMistakes();
}

void tst_QuickFixes::aFixIsOfferedAndHelps() {
    QFETCH(QString, text);
    QFETCH(QString, code);
    QFETCH(QString, title);
    QFETCH(QString, expected);
    const std::string source = text.toStdString();
    const bool binds = code == "E303" || code == "E304" || code == "E305" || code == "E307";
    const auto check = [binds](std::string_view any) { return binds ? bind(any) : readPlan(any).findings; };
    const Findings findings = check(source);
    const Finding* const finding = findingOf(findings, code.toStdString());
    QVERIFY2(finding, findings.empty() ? "nothing is wrong" : toText(findings.front()).c_str());
    const std::vector<QuickFix> fixes = quickFixes(source, *finding, robot, check);
    const auto fix = std::find_if(fixes.begin(), fixes.end(), [&title](const QuickFix& candidate) {
        return QString::fromStdString(candidate.title).contains(title);
    });
    QVERIFY2(fix != fixes.end(), titlesOf(fixes).c_str());
    const std::string fixed = withFix(source, *fix);
    QVERIFY2(!findingOf(check(fixed), code.toStdString()), fixed.c_str());
    if (!expected.isEmpty())
        QCOMPARE(QString::fromStdString(fixed), expected);
}

void tst_QuickFixes::everyOfferedFixHelps() {
    int fixed = 0;
    int files = 0;
    for (const corpus::PlanFile& file : corpus::planFiles()) {
        const Findings findings = readPlan(file.text).findings;
        if (findings.empty() || file.text.size() > 20000)
            continue;
        ++files;
        const std::vector<QuickFix> fixes = quickFixes(file.text, findings.front());
        fixed += fixes.empty() ? 0 : 1;
        for (const QuickFix& fix : fixes)
            QVERIFY2(readPlan(withFix(file.text, fix)).findings != findings, (file.name + ": " + fix.title).c_str());
    }
    qInfo("%d of %d files with findings have a fix for the first of them", fixed, files);
    QVERIFY(fixed * 10 >= files * 8);
}

/// Whatever a hand does to a text.
void tst_QuickFixes::mendsOfDamagedTextsAreInOrderAndHelp() {
    const std::string sound = "((documentation \"a\" \"b\" \"c\")\n"
                              " (C c vars($x=1) (minutes 2) (goal ((Near 3 <)))\n"
                              "  (elements ((e (trigger ((Bumped))) Drive($x, $y='z) 3 \"why\")) ((f Stop))))\n"
                              " (AP p (Stop Beep(2) (Near)))\n"
                              " (DC d (goal nil) (drives ((g (trigger ((Battery 0.5 >))) c (hz 2))) ((h p)))))\n";
    const std::string pieces = "()\"'$;, .<=x1-\\\xc3\xa4\n";
    int fixed = 0;
    for (std::uint64_t seed = 0; seed < 800; ++seed) {
        Random random = seeded(seed, 9);
        std::string text = sound;
        for (std::uint64_t times = random() % 3 + 1; times > 0; --times) {
            const std::size_t at = random() % (text.size() + 1);
            if (random() % 2 == 0)
                text.insert(at, 1, pieces[random() % pieces.size()]);
            else
                text.erase(at, random() % 6 + 1);
        }
        const Findings findings = readPlan(text).findings;
        for (const Finding& finding : findings)
            for (const QuickFix& fix : quickFixes(text, finding, robot)) {
                std::size_t end = 0;
                for (const Splice& edit : fix.edits) {
                    QVERIFY2(edit.begin >= end && edit.end >= edit.begin && edit.end <= text.size(), fix.title.c_str());
                    end = edit.end;
                }
                QVERIFY(withFix(text, fix) != text);
                ++fixed;
            }
    }
    QVERIFY2(fixed > 1000, qPrintable(QString::number(fixed)));
}

void tst_QuickFixes::differenceIsShortAndWhole_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QByteArray>("piece");
    QTest::newRow("nothing") << QByteArray("abc") << QByteArray("abc") << QByteArray();
    QTest::newRow("in the middle") << QByteArray("abcd") << QByteArray("aXYd") << QByteArray("XY");
    QTest::newRow("more of the same") << QByteArray("aaa") << QByteArray("aaaa") << QByteArray("a");
    QTest::newRow("less") << QByteArray("abcbcd") << QByteArray("abcd") << QByteArray("");
    QTest::newRow("characters are not cut")
        << QByteArray("\xc3\xa4") << QByteArray("\xc3\xb6") << QByteArray("\xc3\xb6");
    QTest::newRow("from nothing") << QByteArray() << QByteArray("x") << QByteArray("x");
}

void tst_QuickFixes::differenceIsShortAndWhole() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QByteArray, piece);
    const std::vector<Splice> edits = difference(before.toStdString(), after.toStdString());
    QCOMPARE(edits.empty(), before == after);
    QCOMPARE(QByteArray::fromStdString(withFix(before.toStdString(), {"", edits})), after);
    if (!edits.empty())
        QCOMPARE(QByteArray::fromStdString(edits.front().text), piece);
}

USAR_TEST(tst_QuickFixes)

} // namespace tst_quick_fixes

#include "tst_quick_fixes.moc"
