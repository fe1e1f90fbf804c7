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
};

void tst_RadioLosses::aPairThatWasNeverLinkedHasLostNothing() {
    RadioLosses losses;
    QVERIFY(losses.take(strength(std::nullopt), both).empty());
    QVERIFY(losses.take(strength(radio_cutoff_dbm - 1.0), both).empty());
    QVERIFY(losses.take(strength(radio_cutoff_dbm), both).empty());
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
    QCOMPARE(lost.size(), 1u);
    QVERIFY2(lost[0].reason.contains(words), qPrintable(lost[0].reason));
    QVERIFY(losses.take(weak, both).empty());
    const auto back = losses.take(strength(radio_cutoff_dbm + 10.0), both);
    QCOMPARE(back.size(), 1u);
    QCOMPARE(back[0].key, lost[0].key);
    QVERIFY(back[0].reason.isEmpty());
}

void tst_RadioLosses::theLossOfARobotThatIsGoneIsOver() {
    RadioLosses losses;
    losses.take(strength(radio_cutoff_dbm + 10.0), both);
    const auto lost = losses.take(strength(std::nullopt), both);
    const auto over = losses.take({}, {"R1"});
    QCOMPARE(over.size(), 1u);
    QCOMPARE(over[0].key, lost.at(0).key);
    QVERIFY(over[0].reason.isEmpty());
    QVERIFY(losses.take(strength(std::nullopt), both).empty()); // it is a new pair
}

USAR_TEST(tst_RadioLosses)

} // namespace tst_radio_losses

#include "tst_radio_losses.moc"
