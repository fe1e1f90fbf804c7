#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/panels/quantity_box.h"
#include "widgets/style/theme.h"

namespace tst_quantity_box {

using namespace usar::widgets;

class tst_QuantityBox : public QObject {
    Q_OBJECT
private slots:
    void showsNoSuperfluousZeros_data();
    void showsNoSuperfluousZeros();
    void readsWhatPeopleType_data();
    void readsWhatPeopleType();
    void lettersAreRefused();
    void valueIsToldWhenCommittedOnly();
    void arrowsStayInTheRange();
    void pointIsAPointInEveryLocale();
    void nonsenseKeepsTheValue();
};

void tst_QuantityBox::showsNoSuperfluousZeros_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::newRow("whole") << 6.0 << 3 << "6";
    QTest::newRow("half") << 6.5 << 3 << "6.5";
    QTest::newRow("all decimals") << 0.125 << 3 << "0.125";
    QTest::newRow("hundred keeps its zeros") << 100.0 << 0 << "100";
    QTest::newRow("hundred with decimals") << 100.0 << 2 << "100";
    QTest::newRow("tiny negative is no minus zero") << -0.0001 << 2 << "0";
    QTest::newRow("negative") << -2.25 << 2 << "-2.25";
}

void tst_QuantityBox::showsNoSuperfluousZeros() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QuantityBox box;
    box.setDecimals(decimals);
    QTEST(box.textFromValue(value), "text");
}

void tst_QuantityBox::readsWhatPeopleType_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("value");
    QTest::newRow("whole") << "12" << 12.0;
    QTest::newRow("point") << "12.5" << 12.5;
    QTest::newRow("comma") << "12,5" << 12.5;
    QTest::newRow("negative") << "-3" << -3.0;
    QTest::newRow("below the range") << "-999" << -50.0;
    QTest::newRow("above the range") << "99" << 50.0;
}

void tst_QuantityBox::readsWhatPeopleType() {
    QFETCH(QString, typed);
    QuantityBox box;
    box.setSuffix(QStringLiteral("\u00a0m"));
    box.setDecimals(2);
    box.setRange(-50.0, 50.0);
    box.setValue(1.0);
    box.findChild<QLineEdit*>()->setText(typed);
    box.interpretText();
    QTEST(box.value(), "value");
}

void tst_QuantityBox::lettersAreRefused() {
    QuantityBox box;
    QString text = QStringLiteral("abc");
    int position = 3;
    QCOMPARE(box.validate(text, position), QValidator::Invalid);
    text = QStringLiteral("-");
    QCOMPARE(box.validate(text, position), QValidator::Intermediate);
    text = QStringLiteral("nan");
    QVERIFY(box.validate(text, position) != QValidator::Acceptable);
}

void tst_QuantityBox::valueIsToldWhenCommittedOnly() {
    QuantityBox box;
    box.setRange(0.0, 1000.0);
    box.show();
    QSignalSpy told(&box, &QDoubleSpinBox::valueChanged);
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("123"));
    QCOMPARE(told.count(), 0);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(told.count(), 1);
    QCOMPARE(told[0][0].toDouble(), 123.0);
}

void tst_QuantityBox::arrowsStayInTheRange() {
    QuantityBox box;
    box.setRange(0.0, 1.0);
    box.setSingleStep(0.75);
    box.show();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(box.value(), 1.0);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&box, Qt::Key_Down);
    QCOMPARE(box.value(), 0.0);
}

void tst_QuantityBox::pointIsAPointInEveryLocale() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    {
        QuantityBox box;
        box.setDecimals(2);
        box.setValue(2.5);
        QCOMPARE(box.text(), QStringLiteral("2.5"));
        box.findChild<QLineEdit*>()->setText(QStringLiteral("3.25"));
        box.interpretText();
        QCOMPARE(box.value(), 3.25);
    }
    QLocale::setDefault(before);
}

void tst_QuantityBox::nonsenseKeepsTheValue() {
    QuantityBox box;
    box.setValue(7.0);
    QCOMPARE(box.valueFromText(QStringLiteral("seven")), 7.0);
    QCOMPARE(box.valueFromText(QString()), 7.0);
}

USAR_TEST(tst_QuantityBox)

} // namespace tst_quantity_box

#include "tst_quantity_box.moc"
