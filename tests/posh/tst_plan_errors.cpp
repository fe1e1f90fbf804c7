// What the reader says of texts that are wrong in more ways than one, or wrong in bulk.
#include <QElapsedTimer>
#include <QTest>

#include "core/base/random.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "plan_corpus.h"
#include "tests/suite/suite.h"

namespace tst_plan_errors {

using namespace usar;
using namespace usar::posh;

namespace {

/// "1:2 E202, 3:4 W404", without messages.
QString codesOf(const Findings& findings) {
    QStringList codes;
    for (const Finding& finding : findings)
        codes << QString("%1:%2 %3").arg(finding.at.line).arg(finding.at.column).arg(toText(finding.code).c_str());
    return codes.join(", ");
}

/// What must hold of any text.
std::string complaintOn(std::string_view text) {
    const PlanReading reading = readPlan(text);
    for (const Finding& finding : reading.findings) {
        if (finding.at.line == 0 || finding.at.column == 0 || finding.at.offset > text.size() ||
            finding.at.length > text.size() - finding.at.offset)
            return "a place outside of the text: " + toText(finding);
        if (finding.message.find("; ") == std::string::npos)
            return "no fix: " + toText(finding);
    }
    if (hasErrors(reading.findings))
        return {};
    const PlanReading again = readPlan(writePlan(reading.plan));
    return again.plan == reading.plan ? "" : "reads back as another plan";
}

std::string repeated(std::string_view text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

} // namespace

class tst_PlanErrors : public QObject {
    Q_OBJECT
private slots:
    void severalErrorsAreFoundInOnePass_data();
    void severalErrorsAreFoundInOnePass();
    void warningsSayWhere_data();
    void warningsSayWhere();
    void messagesNameTheFix_data();
    void messagesNameTheFix();
    void aMissingParenthesisIsToldWithItsOpener();
    void everyPrefixOfEveryPlanIsRead();
    void damagedPlansAreRead();
    void hugeTextsTakeLinearTime_data();
    void hugeTextsTakeLinearTime();
    void manyBadCharactersAreToldOnce();
};

void tst_PlanErrors::severalErrorsAreFoundInOnePass_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("codes");
    const auto row = [](const char* name, const char* text, const char* codes) {
        QTest::newRow(name) << QByteArray(text) << QString(codes);
    };
    row("one in each form", "(\n(C c (elements ((e act 1.5))))\n(AP p ())\n(DC d (drives ((a c) oops))))",
        "2:24 E219, 3:8 E218, 4:22 E202");
    row("a form that is never closed", "(\n (C c (elements ((e act)))\n (AP p ())\n (DC d (drives ((a c)))))",
        "3:2 E202, 3:9 E218");
    row("behind a plan that closes too early", "((C c (elements ((e act)))))\n(AP p ())\n(DC d (drives ((a c)))))",
        "2:1 E204, 2:8 E218");
    row("a form without its first parenthesis",
        "(\n C k (elements ((e act 1.5))))\n AP p (a))\n(DC d (drives ((a p) x))))",
        "2:2 E202, 2:24 E219, 3:2 E202, 4:22 E202");
    row("junk between forms", "( x y (AP p (a)) 3 (DC d (drives ((a p)))))", "1:3 E202, 1:18 E202");
    row("errors of the text and of the plan", "((C c (elements ((e c))))\n (AP p)\n (DC d (drives ((a c)))))",
        "2:7 E202, 1:21 E302");
    row("names and variables", "((AP p (a($x)))\n (AP p vars($y=1) (a($z, $y)))\n (DC d (drives ((a p)))))",
        "1:11 E306, 2:6 E301, 2:22 E306");
    row("a string that is never closed ends with its line",
        "((documentation \"a\" \"b\" \"c)\n (AP p ()) (DC d (drives ())))", "1:25 E102, 2:9 E218, 2:27 E202");
    row("several malformed words", "((AP p (1.2.3))\n (AP q (a(')))\n (AP r ($))\n (DC d (drives ((a @)))))",
        "1:9 E104, 2:11 E105, 3:9 E106, 4:20 E101");
    row("a cycle is closed as the text goes, wherever the collection stands",
        "((DC l (drives ((a q))))\n (AP p (q))\n (AP q (p)))", "3:9 E302");
    row("each cycle is closed once",
        "((C c (elements ((e c) (f d))))\n (C d (elements ((e c) (f d))))\n (DC l (drives ((a c)))))",
        "1:21 E302, 2:21 E302, 2:27 E302");
}

void tst_PlanErrors::severalErrorsAreFoundInOnePass() {
    QFETCH(QByteArray, text);
    QFETCH(QString, codes);
    Findings errors = readPlan(text.toStdString()).findings;
    std::erase_if(errors, [](const Finding& finding) { return severityOf(finding.code) != Severity::Error; });
    QCOMPARE(codesOf(errors), codes);
}

void tst_PlanErrors::warningsSayWhere_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("codes");
    const auto row = [](const char* name, const char* text, const char* codes) {
        QTest::newRow(name) << QByteArray(text) << QString(codes);
    };
    row("nothing to say", "((DC d (drives ((a act)))))", "");
    row("a bad byte", "( ; \xFF\n (DC d (drives ((a act)))))", "1:5 W400");
    row("a fragment", "((AP p (a)))", "1:6 W401");
    row("an empty fragment", "()", "1:1 W401");
    row("a drive's name twice", "((DC d (drives ((a (trigger ((s))) x)) ((a y)))))", "1:42 W402");
    row("an element's name twice", "((C k (elements ((e (trigger ((s))) x)) ((e y))))\n (DC d (drives ((a k)))))",
        "1:43 W403");
    row("elements of two competences may be called the same",
        "((C k (elements ((e x))))\n (C m (elements ((e x))))\n (DC d (drives ((a (trigger ((s))) k)) ((b m)))))", "");
    row("never used", "((AP p (a))\n (AD q ((goal ((s))) (a)))\n (DC d (drives ((a act)))))", "1:6 W404, 2:6 W404");
    row("odd spaces are told in runs",
        "(\xC2\xA0\xC2\xA0(DC\xE3\x80\x80"
        "d (drives ((a act)))))",
        "1:2 W405, 1:7 W405");
    row("a name that starts with a digit", "((DC d (drives ((a 3act)))))", "1:20 W406");
    row("a word of the language as a name", "((DC goal (drives ((a (trigger ((true))) Hz)))))",
        "1:6 W407, 1:34 W407, 1:42 W407");
    row("a word of the language as a value", "((DC d (drives ((a (trigger ((s none))) act)))))", "");
    row("no elements", "((C k (elements))\n (DC d (drives ((a k)))))", "1:8 W408");
    row("zero retries", "((C k (elements ((e act 0))))\n (DC d (drives ((a k)))))", "1:25 W409");
    row("an element behind one that is always ready",
        "((C k (elements ((e x) (f y)) ((g z))))\n (DC d (drives ((a k)))))", "1:25 W410, 1:33 W410");
    row("an element behind one with a limit", "((C k (elements ((e x 2)) ((g z))))\n (DC d (drives ((a k)))))", "");
    row("a drive behind one that is always ready", "((DC d (drives ((a x)) ((b y)))))", "1:26 W410");
    row("drives of one level take turns", "((DC d (drives ((a x) (b y)))))", "");
    row("a drive behind one with a frequency", "((DC d (drives ((a x (hz 1))) ((b y)))))", "");
    row("a frequency without limit is none", "((DC d (drives ((a x (none 0))) ((b y)))))", "1:35 W410");
    row("a competence that may find nothing", "((C k (elements ((e (trigger ((s))) x))))\n (DC d (drives ((a k)))))",
        "1:5 W411");
    row("a competence with a goal", "((C k (goal ((t))) (elements ((e (trigger ((s))) x))))\n (DC d (drives ((a k)))))",
        "");
    row("arguments that are not declared", "((AP p vars($x=1) (a($x)))\n (DC d (drives ((a p(1, 2, $y=3))))))",
        "2:25 W412, 2:28 W412");
    row("arguments of a primitive are its own", "((DC d (drives ((a act(1, $y=3))))))", "");
}

void tst_PlanErrors::warningsSayWhere() {
    QFETCH(QByteArray, text);
    QFETCH(QString, codes);
    QCOMPARE(codesOf(readPlan(text.toStdString()).findings), codes);
}

void tst_PlanErrors::messagesNameTheFix_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("fix");
    const auto row = [](const char* name, const char* text, const char* fix) {
        QTest::newRow(name) << QByteArray(text) << QString(fix);
    };
    row("a misspelt trigger", "((DC d (drives ((a (triger ((s))) act)))))", "; write trigger");
    row("a misspelt unit", "((DC d (drives ((a act (second 2))))))", "; write seconds");
    row("a rate as a limit", "((C k (pm 2) (elements ((e x)))))", "; write none, which is a time");
    row("a comparison before its value", "((DC d (drives ((a (trigger ((far < 3))) act)))))", "(far 3 <)");
    row("a bare word as an argument", "((DC d (drives ((a act(red))))))", "; write 'red");
    row("a parameter without default", "((AP p vars($x) (a)))", "; write $x=value");
    row("a misspelt parameter", "((AP p vars($speed=1) (a($sped))))", "; write $speed or declare it");
    row("a misspelt documentation", "((documentaton \"a\" \"b\" \"c\"))", "; write documentation");
    row("a name that is taken", "((AP p (a)) (AP p (a)))", "is already used at 1:6; give this one another name");
    row("a cycle", "((AP p (q)) (AP q (r)) (AP r (p)))", "\"p\" contains itself through \"q\", \"r\"; ");
}

void tst_PlanErrors::messagesNameTheFix() {
    QFETCH(QByteArray, text);
    QFETCH(QString, fix);
    Findings findings = readPlan(text.toStdString()).findings;
    std::erase_if(findings, [](const Finding& finding) { return severityOf(finding.code) != Severity::Error; });
    QVERIFY(!findings.empty());
    const QString message = QString::fromStdString(findings.front().message);
    QVERIFY2(message.contains(fix), qPrintable(message));
}

void tst_PlanErrors::aMissingParenthesisIsToldWithItsOpener() {
    const Findings findings = readPlan("(\n  (DC d (drives ((a act)))\n").findings;
    QCOMPARE(codesOf(findings), QString("3:1 E203"));
    QVERIFY(findings[0].opener);
    QCOMPARE(QString::fromStdString(toText(findings[0])).section('(', -1), QString("the parenthesis at 2:3 is open)"));
}

void tst_PlanErrors::everyPrefixOfEveryPlanIsRead() {
    for (const corpus::PlanFile& file : corpus::planFiles()) {
        const std::size_t step = file.text.size() / 1500 + 1;
        for (std::size_t size = 0; size <= file.text.size(); size += step) {
            const std::string complaint = complaintOn(std::string_view(file.text).substr(0, size));
            if (!complaint.empty())
                QFAIL((file.name + " cut at " + std::to_string(size) + ": " + complaint).c_str());
        }
    }
}

void tst_PlanErrors::damagedPlansAreRead() {
    Random random = seeded(1, 1);
    constexpr std::string_view bits = "()()()\"',$;#\\=<>!. \n\t-0AaC\xFF\xC3\xA0";
    for (const corpus::PlanFile& file : corpus::planFiles())
        for (int round = 0; round < 40 && !file.text.empty(); ++round) {
            std::string text = file.text;
            for (int damage = 0; damage <= round % 8; ++damage) {
                const std::size_t at = random() % text.size();
                const char bit = bits[random() % bits.size()];
                if (random() % 2 == 0)
                    text[at] = bit;
                else
                    text.insert(at, 1, bit);
            }
            const std::string complaint = complaintOn(text);
            if (!complaint.empty())
                QFAIL((file.name + ": " + complaint + " in\n" + text).c_str());
        }
}

void tst_PlanErrors::hugeTextsTakeLinearTime_data() {
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const std::string& text) {
        QTest::newRow(name) << QByteArray::fromStdString(text);
    };
    constexpr int many = 200000;
    row("only openers", repeated("(", many));
    row("only closers", "(" + repeated(")", many));
    row("deep nesting in a trigger", "((DC d (drives ((a (trigger " + repeated("(", many));
    row("quotes that are escaped", repeated("\"\\\"\n", many));
    row("unclosed strings", "(" + repeated("(AP \"\n", many));
    row("bad forms", "(" + repeated("\n(C c", many));
    row("bad forms on one line", "(" + repeated("(C c ", many));
    row("bad characters", repeated("@ ", many));
    row("bad bytes", repeated("\xFF", many));
    row("arguments", "((DC d (drives ((a act(" + repeated("$x=1,", many) + "$y=1))))))");
    std::string names = "((DC d (drives ((a act($a=1";
    std::string chain = "(";
    for (int i = 0; i < many / 10; ++i) {
        names += ",$x" + std::to_string(i) + "=1";
        chain += "(AP p" + std::to_string(i) + " (p" + std::to_string(i + 1) + "))";
    }
    row("arguments with names of their own", names + "))))))");
    row("a deep chain of patterns", chain + "(DC d (drives ((a p0)))))");
    row("arguments that a long name does not declare", "((AP " + repeated("x", many) + " (a))(DC d (drives ((a " +
                                                           repeated("x", many) + "(1" + repeated(",1", many) +
                                                           "))))))");
    row("variables that no form declares", "((AP p vars($" + repeated("x", many) + "=1, $y=1) (a(1" +
                                               repeated(",$z", many) + ")))(DC d (drives ((a p)))))");
    row("comments", "(" + repeated("; c\n\n", many) + ")");
    row("one long name", "((DC " + repeated("x", many * 5) + "))");
    row("one long string", "((documentation \"" + repeated("\\u0041", many) + "\" \"\" \"\"))");
}

void tst_PlanErrors::hugeTextsTakeLinearTime() {
    QFETCH(QByteArray, text);
    QElapsedTimer timer;
    timer.start();
    const std::string complaint = complaintOn({text.data(), static_cast<std::size_t>(text.size())});
    QVERIFY2(complaint.empty(), complaint.c_str());
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed())));
}

void tst_PlanErrors::manyBadCharactersAreToldOnce() {
    const Findings findings = readPlan("( ;" + repeated("\xFF", 100000) + "\n(DC d (drives ((a act)))))").findings;
    QVERIFY(findings.size() <= 101);
    QVERIFY(QString::fromStdString(findings.back().message).startsWith("there are more"));
}

USAR_TEST(tst_PlanErrors)

} // namespace tst_plan_errors

#include "tst_plan_errors.moc"
