// Plans made ready to run: arguments, equal calls, paths, depth.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_program {

using namespace usar::posh;

class tst_Program : public QObject {
    Q_OBJECT
private slots:
    void defaultsServeWhereArgumentsAreMissing();
    void aDeepChainOfFormsRuns();
    void undeclaredArgumentsReachNobody();
    void equalCallsAreOne();
    void everyPlaceHasItsPath();
    void plansOfTheSameShape_data();
    void plansOfTheSameShape();
    void aPlaceIsFoundByPathOrNames();
};

void tst_Program::defaultsServeWhereArgumentsAreMissing() {
    Trial trial("((AP p vars($a=1, $b='red) (fly($b, $x=$a))) (DC d (drives ((one p) (two p(2.0, $b=\"blue\"))))))");
    QVERIFY(trial.cycle(0).contains("init fly('red, $x=1)"));
    QVERIFY(trial.cycle(1).contains("init fly(\"blue\", $x=2.0)"));
}

void tst_Program::aDeepChainOfFormsRuns() {
    std::string plan = "((DC d (drives ((work c0))))";
    for (int i = 0; i < 5000; ++i)
        plan += "(C c" + std::to_string(i) + " (elements ((e " +
                (i == 4999 ? std::string("walk") : "c" + std::to_string(i + 1)) + "))))";
    Trial trial(plan + ")");
    trial.engine.watch(nullptr); // the text of such paths is long
    QCOMPARE(trial.engine.cycle(Milliseconds(0)), Outcome::Fired);
    QCOMPARE(trial.host.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_Program::undeclaredArgumentsReachNobody() {
    Trial trial("((C c vars($a=1) (elements ((e p($a, $b=7))))) (AP p vars($a=2) (q)) (AP q vars($b=3) (fly($b))) "
                "(DC d (drives ((one c(5, 6))))))");
    QVERIFY(trial.cycle(0).contains("init fly(3)"));
}

void tst_Program::equalCallsAreOne() {
    const auto program = programOf("((AP p vars($x=2) (fly(2) fly($x) fly(2.0) fly($to=2) fly)) (DC d (drives ((a "
                                   "(trigger ((near) (near 3 <))) p)))))");
    QCOMPARE(program->sense_calls.size(), std::size_t(1));
    QCOMPARE(program->act_calls.size(), std::size_t(4));
}

void tst_Program::everyPlaceHasItsPath() {
    const auto program =
        programOf("((AD k ((goal ((x))) (p))) (C c (elements ((e1 walk) (e2 k)))) (AP p (one (y) two)) "
                  "(DC d (drives ((a sit)) ((b c)))))");
    QStringList paths;
    for (Index place = 0; place < program->places.size(); ++place)
        paths << QString::fromStdString(pathOf(*program, place) + " " + nameOf(*program, place));
    for (const char* const expected :
         {"/P:0/DC:0 d", "/P:0/DC:0/DE:0/A:0 sit", "/P:0/DC:0/DE:1/A:0/C:0/CE:0/A:0 walk",
          "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AD:0/S:0 x", "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AD:0/A:0/AP:0/A:1 y",
          "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AD:0/A:0/AP:0/A:2 two"})
        QVERIFY2(paths.contains(expected), expected);
    QCOMPARE(namePathOf(*program, program->acts.back().place), std::string("d ▸ b ▸ c ▸ e2 ▸ k ▸ p ▸ two"));
}

void tst_Program::plansOfTheSameShape_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<bool>("same");
    const auto row = [](const char* claim, const char* from, const char* to, bool same) {
        QTest::newRow(claim) << QByteArray(from) << QByteArray(to) << same;
    };
    row("layout", "((a", "( ; slowly\n (a", true);
    row("an operand", "0.3 <", "0.4 <", true);
    row("a predicate", "0.3 <", "0.3 >=", true);
    row("an operand less", "(near 0.3 <)", "(near)", true);
    row("retries", "walk 3", "walk 5", true);
    row("a time limit", "(C c", "(C c (seconds 3)", true);
    row("a frequency", "(b c)", "(b c (hz 2))", true);
    row("names of drives and elements", "(e walk", "(first walk", true);
    row("another sense", "(near 0.3 <)", "(far 0.3 <)", false);
    row("a sense more", "(near 0.3 <)", "(near 0.3 <) (far)", false);
    row("another act", "walk 3", "run 3", false);
    row("another argument", "fly(1)", "fly(2)", false);
    row("another order", "((a (trigger ((near 0.3 <))) fly(1))) ((b c))",
        "((b c)) ((a (trigger ((near 0.3 <))) fly(1)))", false);
    row("equals", "fly(1))) ((b c))", "fly(1)) (b c))", false);
    row("an element more", "((e walk 3))", "((e walk 3)) ((f rest))", false);
    row("a goal", "(DC d", "(DC d (goal ((near)))", false);
}

void tst_Program::plansOfTheSameShape() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(bool, same);
    const QByteArray plan =
        "((C c (elements ((e walk 3)))) (DC d (drives ((a (trigger ((near 0.3 <))) fly(1))) ((b c)))))";
    QByteArray changed = plan;
    QCOMPARE(plan.count(from), 1);
    changed.replace(from, to);
    const auto one = programOf(plan.toStdString());
    const auto other = programOf(changed.toStdString());
    QCOMPARE(sameShape(*one, *other), same);
    QCOMPARE(sameShape(*other, *one), same);
}

void tst_Program::aPlaceIsFoundByPathOrNames() {
    const auto program = programOf("((DC d (drives ((a walk)) ((b run)) ((b sit)))))");
    const auto pathFound = [&](const char* path, const char* names) {
        const Index place = findPlace(*program, path, names);
        return place == nowhere ? std::string("nowhere") : pathOf(*program, place);
    };
    QCOMPARE(pathFound("/P:0/DC:0/DE:2", "d ▸ b"), std::string("/P:0/DC:0/DE:2"));
    QCOMPARE(pathFound("/P:0/DC:0/DE:0", "d ▸ b"), std::string("/P:0/DC:0/DE:1"));
    QCOMPARE(pathFound("/P:0/DC:0/DE:0", "d ▸ c"), std::string("nowhere"));
}

USAR_TEST(tst_Program)

} // namespace tst_program

#include "tst_program.moc"
