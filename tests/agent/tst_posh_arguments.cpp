// Arguments of calls in plans: what each type of parameter takes, and what is said about the rest.
#include <limits>

#include <QTest>

#include "core/agent/posh_registry.h"
#include "core/posh/run/value_text.h"
#include "tests/suite/suite.h"

namespace tst_posh_arguments {

using namespace usar;
using namespace usar::agent;
using posh::Symbol;
using posh::Value;

namespace {

const PoshParameter speed = PoshParameter::number("speed", 1.0, "m/s", 0.0, 9.0);
const PoshParameter offset = PoshParameter::number("offset", 0.0, "m", 0.0, 0.0);
const PoshParameter lanes = PoshParameter::whole("lanes", 4, 1, 9);
const PoshParameter loud = PoshParameter::flag("loud", true);
const PoshParameter note = PoshParameter::text("note", "hi");
const PoshParameter side = PoshParameter::symbol("side", "left", {"left", "right"});
const PoshParameter any = PoshParameter::symbol("any", "x", {});

PrimitiveDescription fly() {
    PrimitiveDescription primitive;
    primitive.name = "Fly";
    primitive.parameters = {speed, side};
    return primitive;
}

Value whole(std::int64_t number) {
    return number;
}

Value text(const char* words) {
    return std::string(words);
}

} // namespace

class tst_PoshArguments : public QObject {
    Q_OBJECT
private slots:
    void valuesBecomeTheTypeOfTheParameter_data() {
        QTest::addColumn<PoshParameter>("parameter");
        QTest::addColumn<Value>("given");
        QTest::addColumn<QString>("taken");
        QTest::newRow("a real") << speed << Value(2.5) << "2.5";
        QTest::newRow("a whole number for a real") << speed << whole(2) << "2.0";
        QTest::newRow("the smallest") << speed << Value(0.0) << "0.0";
        QTest::newRow("the largest") << speed << Value(9.0) << "9.0";
        QTest::newRow("no range") << offset << Value(-1e6) << "-1000000.0";
        QTest::newRow("a whole number") << lanes << whole(9) << "9";
        QTest::newRow("a flag") << loud << Value(false) << "false";
        QTest::newRow("a text") << note << text("a b") << "\"a b\"";
        QTest::newRow("a symbol") << side << Value(Symbol{"right"}) << "'right";
        QTest::newRow("a text for a symbol") << side << text("right") << "'right";
        QTest::newRow("a constant for a symbol") << side << Value(Symbol{"robot.Side.right"}) << "'right";
        QTest::newRow("any symbol") << any << Value(Symbol{"whatever"}) << "'whatever";
    }
    void valuesBecomeTheTypeOfTheParameter() {
        QFETCH(PoshParameter, parameter);
        QFETCH(Value, given);
        QFETCH(QString, taken);
        const auto value = convertArgument(parameter, given);
        QVERIFY2(value, value ? "" : value.error().c_str());
        QCOMPARE(QString::fromStdString(posh::toText(*value)), taken);
        QCOMPARE(value->index(), parameter.default_value.index());
    }

    void theRestIsRefusedWithWhatWouldDo_data() {
        QTest::addColumn<PoshParameter>("parameter");
        QTest::addColumn<Value>("given");
        QTest::addColumn<QString>("said");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const QString as_speed = "takes $speed as a number from 0 to 9 m/s, not ";
        QTest::newRow("too large") << speed << Value(9.5) << as_speed + "9.5";
        QTest::newRow("too small, whole") << speed << whole(-1) << as_speed + "-1";
        QTest::newRow("no number at all") << speed << Value(nan) << as_speed + "nan";
        QTest::newRow("a text for a number") << speed << text("fast") << as_speed + "\"fast\"";
        QTest::newRow("a flag for a number") << speed << Value(true) << as_speed + "true";
        QTest::newRow("nil for a number") << speed << Value() << as_speed + "nil";
        QTest::newRow("too few") << lanes << whole(0) << "takes $lanes as a whole number from 1 to 9, not 0";
        QTest::newRow("a real for a whole number")
            << lanes << Value(2.0) << "takes $lanes as a whole number from 1 to 9, not 2.0";
        QTest::newRow("a number for a flag") << loud << whole(1) << "takes $loud as true or false, not 1";
        QTest::newRow("a symbol for a text") << note << Value(Symbol{"a"}) << "takes $note as a text, not 'a";
        const QString as_side = "takes $side as one of 'left, 'right, not ";
        QTest::newRow("none of the symbols") << side << Value(Symbol{"up"}) << as_side + "'up";
        QTest::newRow("a symbol in another case") << side << Value(Symbol{"Left"}) << as_side + "'Left";
        QTest::newRow("nil for a symbol") << side << Value() << as_side + "nil";
        QTest::newRow("a number for any symbol") << any << whole(3) << "takes $any as a symbol, not 3";
        QTest::newRow("a text for a number without a range")
            << offset << text("far") << "takes $offset as a number, not \"far\"";
    }
    void theRestIsRefusedWithWhatWouldDo() {
        QFETCH(PoshParameter, parameter);
        QFETCH(Value, given);
        QFETCH(QString, said);
        const auto value = convertArgument(parameter, given);
        QVERIFY(!value);
        QCOMPARE(QString::fromStdString(value.error()), said);
    }

    void argumentsFindTheirParameters_data() {
        using Arguments = std::vector<posh::CallArgument>;
        QTest::addColumn<Arguments>("arguments");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<QString>("side_word");
        QTest::newRow("none, so the defaults") << Arguments{} << 1.0 << "left";
        QTest::newRow("by position") << Arguments{{"", 2.0}, {"", Symbol{"right"}}} << 2.0 << "right";
        QTest::newRow("the first one alone") << Arguments{{"", 3.0}} << 3.0 << "left";
        QTest::newRow("by name, in another order")
            << Arguments{{"side", Symbol{"right"}}, {"speed", 4.0}} << 4.0 << "right";
        QTest::newRow("a name, then a position") << Arguments{{"speed", 5.0}, {"", Symbol{"right"}}} << 5.0 << "right";
        QTest::newRow("the last of two for one parameter") << Arguments{{"", 6.0}, {"speed", 7.0}} << 7.0 << "left";
    }
    void argumentsFindTheirParameters() {
        QFETCH(std::vector<posh::CallArgument>, arguments);
        QFETCH(double, speed_m_s);
        QFETCH(QString, side_word);
        const auto made = PoshArguments::make(fly(), arguments);
        QVERIFY2(made, made ? "" : made.error().c_str());
        QCOMPARE(made->real("speed"), speed_m_s);
        QCOMPARE(QString::fromStdString(made->text("side")), side_word);
    }

    void whatFitsNoParameterIsNamed_data() {
        using Arguments = std::vector<posh::CallArgument>;
        QTest::addColumn<Arguments>("arguments");
        QTest::addColumn<QString>("said");
        QTest::newRow("one too many") << Arguments{{"", 1.0}, {"", Symbol{"left"}}, {"", 2.0}}
                                      << "Fly takes no argument 3";
        QTest::newRow("an unknown name") << Arguments{{"height", 1.0}} << "Fly takes no $height";
        QTest::newRow("a name in another case") << Arguments{{"Speed", 1.0}} << "Fly takes no $Speed";
        QTest::newRow("a bad value") << Arguments{{"speed", 10.0}}
                                     << "Fly takes $speed as a number from 0 to 9 m/s, not 10.0";
        QTest::newRow("values in the wrong order")
            << Arguments{{"", Symbol{"left"}}, {"", 1.0}} << "Fly takes $speed as a number from 0 to 9 m/s, not 'left";
    }
    void whatFitsNoParameterIsNamed() {
        QFETCH(std::vector<posh::CallArgument>, arguments);
        QFETCH(QString, said);
        const auto made = PoshArguments::make(fly(), arguments);
        QVERIFY(!made);
        QCOMPARE(QString::fromStdString(made.error()), said);
    }

    void eachTypeIsReadAsItself() {
        PrimitiveDescription primitive;
        primitive.parameters = {lanes, loud, note, any};
        const auto made = PoshArguments::make(primitive, {});
        QVERIFY(made);
        QCOMPARE(made->whole("lanes"), std::int64_t{4});
        QCOMPARE(made->flag("loud"), true);
        QCOMPARE(made->text("note"), std::string("hi"));
        QCOMPARE(made->text("any"), std::string("x"));
    }
};

USAR_TEST(tst_PoshArguments)

} // namespace tst_posh_arguments

#include "tst_posh_arguments.moc"
