// The values of senses and calls, edited by their types: what was not touched stays as it was written.
#include <algorithm>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "core/posh/edit/plan_phrase.h"
#include "tests/suite/suite.h"
#include "widgets/plan/editor/plan_values_dialog.h"

namespace tst_plan_values {

using namespace usar;
using namespace usar::widgets;
using agent::AnswerType;
using agent::PoshParameter;

namespace {

agent::PrimitiveDescription sense(AnswerType answer) {
    agent::PrimitiveDescription described{"Asked", agent::PrimitiveKind::Sense, {}, answer, "m", "Asks.", {}};
    described.maximum = 8.0;
    described.choices = {"none", "low", "high"};
    return described;
}

agent::PrimitiveDescription drive() {
    return {"DriveTo",
            agent::PrimitiveKind::Act,
            {PoshParameter::symbol("goal", "home", {"home", "depot"}),
             PoshParameter::number("speed", 1.0, "m/s", 0.0, 3.0), PoshParameter::whole("times", 1, 1, 5),
             PoshParameter::flag("fast", false)},
            AnswerType::Any,
            {},
            "Drives.",
            {}};
}

posh::SenseTest testOf(const QString& words) {
    return posh::readSensePhrase(words.toStdString()).value();
}

template <class Field>
Field* field(const QDialog& dialog, const QString& name) {
    for (Field* each : dialog.findChildren<Field*>())
        if (each->accessibleName() == name)
            return each;
    return nullptr;
}

} // namespace

class tst_PlanValues : public QObject {
    Q_OBJECT
private slots:
    void whatIsNotTouchedStays_data();
    void whatIsNotTouchedStays();
    void anOperandIsEditedAsItsTypeWants();
    void aComparisonIsChosen();
    void argumentsKnowTypeRangeAndDefault();
    void anActWithoutParametersSaysSo();
    void whatIsNoValueIsNotTaken();
};

void tst_PlanValues::whatIsNotTouchedStays_data() {
    QTest::addColumn<AnswerType>("answer");
    QTest::addColumn<QString>("words");
    QTest::newRow("truth alone") << AnswerType::Boolean << "Asked";
    QTest::newRow("a truth value") << AnswerType::Boolean << "Asked false";
    QTest::newRow("a number as it was spelled") << AnswerType::Real << "Asked 0.300 <";
    QTest::newRow("a whole number for a real one") << AnswerType::Real << "Asked 2 >=";
    QTest::newRow("a number out of range") << AnswerType::Real << "Asked 99.5 <";
    QTest::newRow("a whole number") << AnswerType::Integer << "Asked 3 !=";
    QTest::newRow("a choice") << AnswerType::Symbol << "Asked 'low ==";
    QTest::newRow("a word that is no choice") << AnswerType::Symbol << "Asked 'odd";
    QTest::newRow("a text") << AnswerType::Text << "Asked \"a b\" =";
    QTest::newRow("of another type than declared") << AnswerType::Real << "Asked true";
    QTest::newRow("undeclared") << AnswerType::Any << "Asked nil !=";
    QTest::newRow("arguments that nobody declares") << AnswerType::Real << "Asked(1, $x=\"y\") 0.5 <";
}

void tst_PlanValues::whatIsNotTouchedStays() {
    QFETCH(AnswerType, answer);
    QFETCH(QString, words);
    const PlanValuesDialog dialog(sense(answer), testOf(words), nullptr);
    QCOMPARE(dialog.test(), testOf(words));
    QCOMPARE(QString::fromStdString(posh::phraseOf(dialog.test())),
             QString::fromStdString(posh::phraseOf(testOf(words))));
    QVERIFY(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
}

void tst_PlanValues::anOperandIsEditedAsItsTypeWants() {
    const PlanValuesDialog real(sense(AnswerType::Real), testOf("Asked 0.3 <"), nullptr);
    auto* const number = field<QuantityBox>(real, "Value");
    QVERIFY(number && number->suffix().contains("m") && number->maximum() == 8.0);
    number->setValue(2.5);
    QCOMPARE(real.test(), testOf("Asked 2.5 <"));
    const PlanValuesDialog whole(sense(AnswerType::Integer), testOf("Asked 3 <"), nullptr);
    field<QSpinBox>(whole, "Value")->setValue(100);
    QCOMPARE(whole.test(), testOf("Asked 8 <")); // its range ends there
    const PlanValuesDialog choice(sense(AnswerType::Symbol), testOf("Asked 'low"), nullptr);
    field<QComboBox>(choice, "Value")->setCurrentText("high");
    QCOMPARE(choice.test(), testOf("Asked 'high"));
    const PlanValuesDialog truth(sense(AnswerType::Boolean), testOf("Asked true"), nullptr);
    field<QComboBox>(truth, "Value")->setCurrentIndex(1);
    QCOMPARE(truth.test(), testOf("Asked false"));
}

void tst_PlanValues::aComparisonIsChosen() {
    const PlanValuesDialog dialog(sense(AnswerType::Real), testOf("Asked"), nullptr);
    auto* const comparison = field<QComboBox>(dialog, "Its answer");
    QVERIFY(!field<QuantityBox>(dialog, "Value")->isEnabled());
    comparison->setCurrentIndex(5); // more than
    QVERIFY(field<QuantityBox>(dialog, "Value")->isEnabled());
    field<QuantityBox>(dialog, "Value")->setValue(1.5);
    QCOMPARE(dialog.test(), testOf("Asked 1.5 >"));
    comparison->setCurrentIndex(0);
    QCOMPARE(dialog.test(), testOf("Asked"));
}

void tst_PlanValues::argumentsKnowTypeRangeAndDefault() {
    const posh::Call call = posh::readCallPhrase("DriveTo('depot, $fast=$hurry)").value();
    const PlanValuesDialog dialog(drive(), call, nullptr);
    QCOMPARE(dialog.call(), call); // defaults are not written down
    field<QComboBox>(dialog, "goal")->setCurrentText("home");
    auto* const speed = field<QuantityBox>(dialog, "speed");
    QVERIFY(speed->value() == 1.0 && speed->maximum() == 3.0 && speed->suffix().contains("m/s"));
    speed->setValue(2.0);
    QCOMPARE(field<QSpinBox>(dialog, "times")->maximum(), 5);
    QCOMPARE(field<QLineEdit>(dialog, "fast")->text(), QString("$hurry"));
    QCOMPARE(dialog.call(), posh::readCallPhrase("DriveTo('home, $fast=$hurry, $speed=2.0)").value());
    QVERIFY(!field<QComboBox>(dialog, "Its answer")); // an act is not compared
}

void tst_PlanValues::anActWithoutParametersSaysSo() {
    const auto says = [](const PlanValuesDialog& dialog) {
        const auto labels = dialog.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) { return label->text() == "It takes no values."; });
    };
    agent::PrimitiveDescription halt;
    halt.name = "Halt";
    halt.kind = agent::PrimitiveKind::Act;
    QVERIFY(says(PlanValuesDialog(halt, posh::readCallPhrase("Halt").value(), nullptr)));
    QVERIFY(!says(PlanValuesDialog(drive(), posh::readCallPhrase("DriveTo").value(), nullptr)));
}

void tst_PlanValues::whatIsNoValueIsNotTaken() {
    const PlanValuesDialog dialog(sense(AnswerType::Text), testOf("Asked \"a\""), nullptr);
    auto* const words = field<QLineEdit>(dialog, "Value");
    const QPushButton* const take = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    for (const char* wrong : {"", "\"open", "$speed", "1 2"}) {
        words->setText(wrong);
        QVERIFY2(!take->isEnabled(), wrong);
    }
    words->setText("'fine");
    QVERIFY(take->isEnabled());
    QCOMPARE(dialog.test(), testOf("Asked 'fine"));
}

USAR_TEST(tst_PlanValues)

} // namespace tst_plan_values

#include "tst_plan_values.moc"
