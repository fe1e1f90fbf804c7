// Which radio links were lost or are back.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/radio_links.h"

namespace tst_radio_losses {

using namespace usar::widgets;

namespace {

const QStringList both{"R1", "R2"};

std::vector<RadioLink> strength(std::optional<double> strength_dbm) {
    return {{"R1", "R2", strength_dbm}};
}

} // namespace

class tst_RadioLosses : public QObject {
    Q_OBJECT
private slots:
    void aPairThatWasNeverLinkedHasLostNothing();
    void aLossIsToldOnceAndWhenItIsOver_data();
    void aLossIsToldOnceAndWhenItIsOver();
    void theLossOfARobotThatIsGoneIsOver();
    void manyLossesAreOneNoticeThatCountsPairs();
};

void tst_RadioLosses::aPairThatWasNeverLinkedHasLostNothing() {
    RadioLosses losses;
    QVERIFY(!losses.take(strength(std::nullopt), both).has_value());
    QVERIFY(!losses.take(strength(radio_cutoff_dbm - 1.0), both).has_value());
    QVERIFY(!losses.take(strength(radio_cutoff_dbm), both).has_value());
}

void tst_RadioLosses::aLossIsToldOnceAndWhenItIsOver_data() {
    QTest::addColumn<bool>("heard");
    QTest::addColumn<QString>("words");
    QTest::newRow("too weak") << true << "have lost their radio link";
    QTest::newRow("not heard at all") << false << "do not hear each other";
}

void tst_RadioLosses::aLossIsToldOnceAndWhenItIsOver() {
    QFETCH(bool, heard);
    QFETCH(QString, words);
    const auto weak = strength(heard ? std::optional(radio_cutoff_dbm - 0.1) : std::nullopt);
    RadioLosses losses;
    losses.take(strength(radio_cutoff_dbm + 10.0), both);
    const auto lost = losses.take(weak, both);
    QVERIFY(lost && lost->first);
    QVERIFY2(lost->text.contains(words), qPrintable(lost->text));
    QVERIFY(!losses.take(weak, both).has_value());
    const auto back = losses.take(strength(radio_cutoff_dbm + 10.0), both);
    QVERIFY(back && back->text.isEmpty());
}

void tst_RadioLosses::theLossOfARobotThatIsGoneIsOver() {
    RadioLosses losses;
    losses.take(strength(radio_cutoff_dbm + 10.0), both);
    QVERIFY(losses.take(strength(std::nullopt), both));
    const auto over = losses.take({}, {"R1"});
    QVERIFY(over && over->text.isEmpty());
    QVERIFY(!losses.take(strength(std::nullopt), both).has_value()); // it is a new pair
}

void tst_RadioLosses::manyLossesAreOneNoticeThatCountsPairs() {
    QStringList robots;
    std::vector<RadioLink> near;
    for (int i = 1; i <= 9; ++i) {
        for (const QString& other : robots)
            near.push_back({other, QStringLiteral("R%1").arg(i), -50.0});
        robots << QStringLiteral("R%1").arg(i);
    }
    std::vector<RadioLink> far = near;
    for (RadioLink& link : far)
        link.strength_dbm = -99.0;
    RadioLosses losses;
    QVERIFY(!losses.take(near, robots));
    const auto lost = losses.take(far, robots);
    QVERIFY(lost && lost->first);
    QCOMPARE(lost->text, QStringLiteral("36 pairs of robots have lost their radio link: R1 and R2, R1 and R3, "
                                        "R1 and R4, 33 more. The Radio dock shows all links."));
    far.back().strength_dbm = -50.0;
    const auto fewer = losses.take(far, robots);
    QVERIFY2(fewer && !fewer->first && fewer->text.startsWith("35 pairs"), "it is the same notice, and no news");
}

USAR_TEST(tst_RadioLosses)

} // namespace tst_radio_losses

#include "tst_radio_losses.moc"
