// Answers of senses: how often the robot is asked, what the engine answers itself, and what the blackboard's changes
// say.
#include <QTest>

#include <algorithm>

#include "core/posh/run/value_text.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_sense_answers {

using namespace usar::posh;
using usar::test::TraceDetail;

namespace {

/// A plan with one drive that runs an act if these senses hold.
std::string planWith(const std::string& senses) {
    return "((DC d (drives ((a (trigger (" + senses + ")) act)))))";
}

} // namespace

class tst_SenseAnswers : public QObject {
    Q_OBJECT
private slots:
    void eachCallIsAskedOnceInAnEpoch_data();
    void eachCallIsAskedOnceInAnEpoch();
    void anActThatTakesNoTimeMakesAnAnswerOld();
    void anAnswerThatFailedIsNotAskedAgain();
    void anAnswerFromTheLastCycleIsForgotten();
    void builtInSensesAnswerThemselves_data();
    void builtInSensesAnswerThemselves();
    void theRobotsOwnSenseComesFirst();
    void valuesWithoutAnOrderAreWarnedOfOnce();
    void changesOfTheBlackboardAreRead_data();
    void changesOfTheBlackboardAreRead();
    void everyChangeReadsBack();
};

void tst_SenseAnswers::eachCallIsAskedOnceInAnEpoch_data() {
    QTest::addColumn<QByteArray>("senses");
    QTest::addColumn<int>("asked");
    QTest::newRow("one") << QByteArray("(near)") << 1;
    QTest::newRow("the same twice") << QByteArray("(near) (near)") << 1;
    QTest::newRow("compared with other values") << QByteArray("(near 0 >) (near true) (near false !=)") << 1;
    QTest::newRow("other arguments") << QByteArray("(near(1)) (near(2))") << 2;
    QTest::newRow("the same arguments") << QByteArray("(near(1, $x=2)) (near(1, $x=2))") << 1;
    QTest::newRow("the same arguments, one with a name") << QByteArray("(near(1)) (near($x=1))") << 2;
    QTest::newRow("a whole number and a float") << QByteArray("(near(1)) (near(1.0))") << 2;
    QTest::newRow("the same number, spelled otherwise") << QByteArray("(near(1.0)) (near(1.00)) (near(1e0))") << 1;
    QTest::newRow("a text and a symbol") << QByteArray("(near(\"a\")) (near('a))") << 2;
    QTest::newRow("the same text, spelled otherwise") << QByteArray("(near(\"a\")) (near(\"\\u0061\"))") << 1;
    QTest::newRow("after one that does not hold") << QByteArray("(far) (near)") << 0;
}

void tst_SenseAnswers::eachCallIsAskedOnceInAnEpoch() {
    QFETCH(QByteArray, senses);
    QFETCH(int, asked);
    Trial trial(planWith(senses.toStdString()));
    trial.host.setSense("near", true);
    trial.cycle(0);
    QCOMPARE(int(std::ranges::count(trial.host.calls, "sense near")), asked);
    trial.cycle(1);
    QCOMPARE(int(std::ranges::count(trial.host.calls, "sense near")), 2 * asked);
}

void tst_SenseAnswers::anActThatTakesNoTimeMakesAnAnswerOld() {
    Trial trial(planWith("(near)"), {.most_acts = 4});
    trial.host.setSense("near", true);
    trial.host.setResult("act", ActResult::Finished);
    trial.cycle(0);
    QCOMPARE(std::ranges::count(trial.host.calls, "sense near"), 4);
    QCOMPARE(std::ranges::count(trial.host.calls, "run act"), 4);
}

void tst_SenseAnswers::anAnswerThatFailedIsNotAskedAgain() {
    Trial trial("((DC d (drives ((a (trigger ((near) (far))) act) (b (trigger ((near nil))) act)) ((c sit)))))");
    trial.host.throws = {"sense near"};
    QVERIFY(trial.cycle(0).startsWith("sense near -> nil F; sense near -> nil F cached; start c"));
    QCOMPARE(std::ranges::count(trial.host.calls, "sense near"), 1);
    trial.host.throws.clear();
    QVERIFY(trial.cycle(1).startsWith("sense near -> nil F; sense near -> nil T cached; start b"));
}

void tst_SenseAnswers::anAnswerFromTheLastCycleIsForgotten() {
    Trial trial(planWith("(near)"));
    trial.host.setSense("near", true);
    QVERIFY(trial.cycle(0).startsWith("sense near -> true T; start a"));
    trial.host.setSense("near", std::int64_t{0});
    QCOMPARE(trial.cycle(1), "sense near -> 0 F; end Idle");
    trial.host.setSense("near", std::string());
    QCOMPARE(trial.cycle(2), "sense near -> \"\" F; end Idle");
    trial.host.setSense("near", Symbol{"no"});
    QVERIFY(trial.cycle(3).startsWith("sense near -> 'no T; start a"));
}

void tst_SenseAnswers::builtInSensesAnswerThemselves_data() {
    QTest::addColumn<QByteArray>("sense");
    QTest::addColumn<QString>("events");
    const auto row = [](const char* sense, const char* events) {
        QTest::newRow(sense) << QByteArray(sense) << QString(events);
    };
    row("(succeed)", "sense succeed -> true T; start a");
    row("(Succeed)", "sense Succeed -> true T; start a");
    row("(true)", "sense true -> true T; start a");
    row("(succeed 0 >)", "sense succeed -> true T; start a");
    row("(succeed false)", "sense succeed -> true F; end Idle");
    row("(fail)", "sense fail -> false F; end Idle");
    row("(Fail)", "sense Fail -> false F; end Idle");
    row("(false)", "sense false -> false F; end Idle");
    row("(fail false)", "sense fail -> false T; start a");
    row("(cz.cuni.amis.pogamut.sposh.executor.Succeed)",
        "sense cz.cuni.amis.pogamut.sposh.executor.Succeed -> true T; start a");
    row("(cz.cuni.amis.pogamut.sposh.executor.Fail)",
        "sense cz.cuni.amis.pogamut.sposh.executor.Fail -> false F; end Idle");
    row("(SUCCEED)", "sense SUCCEED -> nil F; end Idle");
    row("(other.Succeed)", "sense other.Succeed -> nil F; end Idle");
}

void tst_SenseAnswers::builtInSensesAnswerThemselves() {
    QFETCH(QByteArray, sense);
    QFETCH(QString, events);
    Trial trial(planWith(sense.toStdString()));
    const QString got = trial.cycle(0);
    QVERIFY2(got.startsWith(events), qPrintable(got));
    QCOMPARE(trial.host.calls.empty() || !trial.host.calls.front().starts_with("sense"), !events.contains("nil"));
}

void tst_SenseAnswers::theRobotsOwnSenseComesFirst() {
    Trial trial(planWith("(fail)"));
    QCOMPARE(trial.cycle(0), "sense fail -> false F; end Idle");
    trial.host.setSense("fail", true);
    trial.engine.replace(programOf(planWith("(fail)")));
    QVERIFY(trial.cycle(1).startsWith("sense fail -> true T; start a"));
    QCOMPARE(trial.host.calls.front(), std::string("sense fail"));
}

void tst_SenseAnswers::valuesWithoutAnOrderAreWarnedOfOnce() {
    Trial trial(planWith("(near 3 <)"), {}, TraceDetail::Full);
    trial.host.setSense("near", std::string("far"));
    const QString first = trial.cycle(0);
    QVERIFY2(first.contains("warn answer and operand have no order"), qPrintable(first));
    QVERIFY(first.contains("sense near -> \"far\" F"));
    QVERIFY(!trial.cycle(1).contains("warn"));
    trial.host.setSense("near", std::int64_t{2});
    QVERIFY(trial.cycle(2).contains("sense near -> 2 T"));
}

void tst_SenseAnswers::changesOfTheBlackboardAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("parts"); // empty if the text is malformed
    const auto row = [](const char* name, const char* text, const QStringList& parts) {
        QTest::newRow(name) << QByteArray(text) << parts;
    };
    row("numbers", "lane: 2 -> 3", {"lane", "2", "3"});
    row("nil and a symbol", "errand: nil -> 'home", {"errand", "nil", "'home"});
    row("an arrow in the old text", "a: \"x -> y\" -> 'z", {"a", "\"x -> y\"", "'z"});
    row("an arrow in the new text", "a: 1 -> \"x -> y\"", {"a", "1", "\"x -> y\""});
    row("a quote in the old text", "a: \"x\\\" -> y\" -> 2", {"a", "\"x\\\" -> y\"", "2"});
    row("a backslash at the end of the old text", "a: \"x\\\\\" -> 2", {"a", "\"x\\\\\"", "2"});
    row("a colon in the old text", "a: \"b: c\" -> 2", {"a", "\"b: c\"", "2"});
    row("a colon in the key", "a:b: 1 -> 2", {"a:b", "1", "2"});
    row("empty values", "a:  -> ", {"a", "", ""});
    row("nothing", "", {});
    row("no key", ": 2 -> 3", {});
    row("no end of the key", "lane 2 -> 3", {});
    row("no arrow", "lane: 2", {});
    row("an arrow without blanks", "lane: 2->3", {});
    row("a text that never ends", "lane: \"2 -> 3", {});
    row("a text that ends with its escape", "lane: \"2\\", {});
    row("words after the old text", "lane: \"2\" x -> 3", {});
}

void tst_SenseAnswers::changesOfTheBlackboardAreRead() {
    QFETCH(QByteArray, text);
    QFETCH(QStringList, parts);
    const std::string words = text.toStdString();
    QStringList got;
    if (const auto change = readBoardChange(words))
        for (const std::string_view part : {change->key, change->old_value, change->new_value})
            got << QString::fromStdString(std::string(part));
    QCOMPARE(got, parts);
}

void tst_SenseAnswers::everyChangeReadsBack() {
    const std::vector<Value> values{{},
                                    true,
                                    std::int64_t{-7},
                                    2.5,
                                    Symbol{"a.b"},
                                    std::string(),
                                    std::string("a -> b: c"),
                                    std::string("\"\\\n\x01")};
    for (const Value& before : values)
        for (const Value& after : values) {
            const std::string text = boardChangeText("key-1", toText(before), toText(after));
            const auto change = readBoardChange(text);
            QVERIFY2(change, text.c_str());
            QCOMPARE(std::string(change->key), std::string("key-1"));
            QCOMPARE(std::string(change->old_value), toText(before));
            QCOMPARE(std::string(change->new_value), toText(after));
        }
}

USAR_TEST(tst_SenseAnswers)

} // namespace tst_sense_answers

#include "tst_sense_answers.moc"
