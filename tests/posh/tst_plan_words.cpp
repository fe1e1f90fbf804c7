// The smallest parts of the language: words, their places, and the values they spell.
#include <limits>

#include <QPoint>
#include <QTest>

#include "core/posh/language/plan_reader.h"
#include "core/posh/language/token.h"
#include "core/posh/model/literal.h"
#include "tests/suite/suite.h"

namespace tst_plan_words {

using namespace usar;
using namespace usar::posh;

namespace {

const char* nameOf(TokenKind kind) {
    constexpr const char* names[] = {"(",      ")",       ",",     "Predicate", "String", "Variable",
                                     "Symbol", "Integer", "Float", "Name",      "Bad",    "End"};
    return names[static_cast<std::size_t>(kind)];
}

/// "Name@1:3 Bad@1:5(E101@1:6)".
QString tokensOf(const std::string& text) {
    const TokenList list = tokenize(text);
    QStringList words;
    std::size_t errors = 0;
    for (const Token& token : list.tokens) {
        QString word = QString("%1@%2:%3").arg(nameOf(token.kind)).arg(token.at.line).arg(token.at.column);
        if (token.kind == TokenKind::Bad) {
            const LexicalError& error = list.errors[errors++];
            word += QString("(%1@%2:%3)").arg(toText(error.code).c_str()).arg(error.at.line).arg(error.at.column);
        }
        words << word;
    }
    words.removeLast(); // the end
    return words.join(' ');
}

} // namespace

class tst_PlanWords : public QObject {
    Q_OBJECT
private slots:
    void wordsAreToldApart_data();
    void wordsAreToldApart();
    void placesCountCodePoints_data();
    void placesCountCodePoints();
    void literalsHaveTheirValues_data();
    void literalsHaveTheirValues();
    void valuesAreSpelledSoThatTheyReadBack_data();
    void valuesAreSpelledSoThatTheyReadBack();
    void aValueIsReadAlone_data();
    void aValueIsReadAlone();
    void theEndIsOnePastTheLastCharacter_data();
    void theEndIsOnePastTheLastCharacter();
};

void tst_PlanWords::wordsAreToldApart_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("tokens");
    const auto row = [](const char* name, const char* text, const char* tokens) {
        QTest::newRow(name) << QByteArray(text) << QString(tokens);
    };
    row("whole numbers", "1 +2 -3 007", "Integer@1:1 Integer@1:3 Integer@1:6 Integer@1:9");
    row("fractions", "1.5 1. .5 -.5e3 2e+1 3E5", "Float@1:1 Float@1:5 Float@1:8 Float@1:11 Float@1:17 Float@1:22");
    row("names", "a _b a-1 a.b.C_d", "Name@1:1 Name@1:3 Name@1:6 Name@1:10");
    row("names that start with a digit", "3act 1e 2-x_", "Name@1:1 Name@1:6 Name@1:9");
    row("numbers and what stands at them", "(1)(-2.5)3,4;\n5#\n-6. \"\"7\"\"",
        "(@1:1 Integer@1:2 )@1:3 (@1:4 Float@1:5 )@1:9 Integer@1:10 ,@1:11 Integer@1:12 Integer@2:1 Float@3:1 "
        "String@3:5 Integer@3:7 String@3:8");
    row("no numbers, though they begin like some", "1é 2.5.6 -. - 7_ 8+ 9.a",
        "Bad@1:1(E101@1:2) Bad@1:4(E104@1:4) Bad@1:10(E107@1:10) Bad@1:13(E107@1:13) Name@1:15 Bad@1:18(E104@1:18) "
        "Bad@1:21(E104@1:21)");
    row("keywords in any case, and beginnings of them", "TRIGGER trigge triggers C c DoCuMeNtAtIoN d",
        "Name@1:1 Name@1:9 Name@1:16 Name@1:25 Name@1:27 Name@1:29 Name@1:43");
    row("malformed numbers", "1.2.3 +1x .5x 1e+ -2-",
        "Bad@1:1(E104@1:1) Bad@1:7(E104@1:7) Bad@1:11(E104@1:11) Bad@1:15(E104@1:15) Bad@1:19(E104@1:19)");
    row("malformed names", "a. a..b .a a.1 -a",
        "Bad@1:1(E107@1:1) Bad@1:4(E107@1:4) Bad@1:9(E107@1:9) Bad@1:12(E107@1:12) Bad@1:16(E107@1:16)");
    row("illegal characters", "a@b [ a+b ! \\",
        "Bad@1:1(E101@1:2) Bad@1:5(E101@1:5) Bad@1:7(E107@1:7) Bad@1:11(E101@1:11) Bad@1:13(E101@1:13)");
    row("comparisons", "== = != < > <= >= =<",
        "Predicate@1:1 Predicate@1:4 Predicate@1:6 Predicate@1:9 Predicate@1:11 Predicate@1:13 Predicate@1:16 "
        "Predicate@1:19 Predicate@1:20");
    row("words without blanks", "a(b,$c='d)e\"f\"g<3",
        "Name@1:1 (@1:2 Name@1:3 ,@1:4 Variable@1:5 Predicate@1:7 Symbol@1:8 )@1:10 Name@1:11 String@1:12 Name@1:15 "
        "Predicate@1:16 Integer@1:17");
    row("symbols", "'a 'a-b 'a.b_c '3d", "Symbol@1:1 Symbol@1:4 Symbol@1:9 Symbol@1:16");
    row("malformed symbols", "' '( 'a.b-c 'a@ 'a. ''b",
        "Bad@1:1(E105@1:1) Bad@1:3(E105@1:3) (@1:4 Bad@1:6(E105@1:10) Bad@1:13(E105@1:15) Bad@1:17(E105@1:19) "
        "Bad@1:21(E105@1:21) Symbol@1:22");
    row("malformed variables", "$ $1 $a $( $a.",
        "Bad@1:1(E106@1:1) Bad@1:3(E106@1:3) Variable@1:6 Bad@1:9(E106@1:9) (@1:10 Bad@1:12(E107@1:13)");
    row("escapes", R"("\b\t\n\f\r\'\"\\" "\0\12\377\400" "\u0041\uuu00e9")", "String@1:1 String@1:20 String@1:36");
    row("unknown escapes", R"("a\q" "\8" "\u12" "\u12g4" a)",
        "Bad@1:1(E103@1:3) Bad@1:7(E103@1:8) Bad@1:12(E103@1:13) Bad@1:19(E103@1:20) Name@1:28");
    row("a string that is never closed", "a \"b c\nd", "Name@1:1 Bad@1:3(E102@1:3) Name@2:1");
    row("comments", "a;b\n# c \" (\n\"; # d\" e#f", "Name@1:1 String@3:1 Name@3:9");
}

void tst_PlanWords::wordsAreToldApart() {
    QFETCH(QByteArray, text);
    QFETCH(QString, tokens);
    QCOMPARE(tokensOf(text.toStdString()), tokens);
}

void tst_PlanWords::placesCountCodePoints_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("tokens");
    const auto row = [](const char* name, const char* text, const char* tokens) {
        QTest::newRow(name) << QByteArray(text) << QString(tokens);
    };
    row("a tab is one column", "\t\ta", "Name@1:3");
    row("two, three and four bytes", "\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\"a", "String@1:1 Name@1:6");
    row("a mark at the start is no column",
        "\xEF\xBB\xBF"
        "a",
        "Name@1:1");
    row("a mark in the middle is a space",
        "a\xEF\xBB\xBF"
        "b",
        "Name@1:1 Name@1:3");
    row("odd spaces part words",
        "a\xC2\xA0"
        "b\xE2\x80\x87"
        "c\xE2\x80\xAF"
        "d\xE3\x80\x80"
        "e",
        "Name@1:1 Name@1:3 Name@1:5 Name@1:7 Name@1:9");
    row("bad bytes are one column each", "\"\xFF\xC3\xE2\x82\"a", "String@1:1 Name@1:7");
    row("overlong forms and surrogates are bad bytes", "\"\xC0\x80\xED\xA0\x80\"a", "String@1:1 Name@1:8");
    row("letters beyond ASCII are no names",
        "a\xC3\xA9"
        "b c",
        "Bad@1:1(E101@1:2) Name@1:5");
    row("CR LF ends a line once", "a\r\nb\rc\nd", "Name@1:1 Name@2:1 Name@2:3 Name@3:1");
    row("form feeds and vertical tabs", "a\f\vb", "Name@1:1 Name@1:4");
    row("a string over lines", "\"x\n\xC3\xA9\"a", "String@1:1 Name@2:3");
    row("an error behind wide characters", "\"\xC3\xA9\\q\"", "Bad@1:1(E103@1:3)");
}

void tst_PlanWords::placesCountCodePoints() {
    QFETCH(QByteArray, text);
    QFETCH(QString, tokens);
    QCOMPARE(tokensOf(text.toStdString()), tokens);
}

void tst_PlanWords::literalsHaveTheirValues_data() {
    QTest::addColumn<QByteArray>("spelling");
    QTest::addColumn<Value>("value");
    QTest::newRow("a whole number") << QByteArray("+7") << Value(std::int64_t{7});
    QTest::newRow("the least whole number")
        << QByteArray("-9223372036854775808") << Value(std::numeric_limits<std::int64_t>::min());
    QTest::newRow("a fraction") << QByteArray("-.5E1") << Value(-5.0);
    QTest::newRow("a fraction that ends with its point") << QByteArray("+3.") << Value(3.0);
    QTest::newRow("truth in any case") << QByteArray("True") << Value(true);
    QTest::newRow("nothing in any case") << QByteArray("NIL") << Value();
    QTest::newRow("a symbol") << QByteArray("'red") << Value(Symbol{"red"});
    QTest::newRow("a bare symbol") << QByteArray("red.dish") << Value(Symbol{"red.dish"});
    QTest::newRow("a text") << QByteArray("\"a b\"") << Value(std::string("a b"));
    QTest::newRow("letters after a backslash")
        << QByteArray(R"("\b\t\n\f\r\'\"\\")") << Value(std::string("\b\t\n\f\r'\"\\"));
    QTest::newRow("octal digits") << QByteArray(R"("\101\0\3771\400")")
                                  << Value(std::string("A\0\xC3\xBF"
                                                       "1 0",
                                                       7));
    QTest::newRow("hexadecimal digits") << QByteArray(R"("\u0041\uu20aC")") << Value(std::string("A\xE2\x82\xAC"));
    QTest::newRow("a pair of surrogates") << QByteArray(R"("\ud83d\uDE00")") << Value(std::string("\xF0\x9F\x98\x80"));
    QTest::newRow("halves of pairs") << QByteArray(R"("\ud83dx\ude00\ud83dA")")
                                     << Value(std::string("\xEF\xBF\xBDx\xEF\xBF\xBD\xEF\xBF\xBD"
                                                          "A"));
    QTest::newRow("a bad byte") << QByteArray("\"a\xFF\"") << Value(std::string("a\xEF\xBF\xBD"));
}

void tst_PlanWords::literalsHaveTheirValues() {
    QFETCH(QByteArray, spelling);
    QFETCH(Value, value);
    const PlanReading reading = readPlan("((AP p ((s " + spelling.toStdString() + "))))");
    QVERIFY2(!hasErrors(reading.findings), toText(reading.findings.front()).c_str());
    const SenseTest test = std::get<SenseTest>(std::get<Pattern>(reading.plan.forms.at(0)).steps.at(0));
    QCOMPARE(QByteArray::fromStdString(test.operand->spelling), spelling);
    QVERIFY2(test.operand->value == value, spelled(test.operand->value).c_str());
}

void tst_PlanWords::valuesAreSpelledSoThatTheyReadBack_data() {
    QTest::addColumn<Value>("value");
    QTest::addColumn<QString>("spelling");
    QTest::newRow("nothing") << Value() << "nil";
    QTest::newRow("truth") << Value(false) << "false";
    QTest::newRow("a whole number") << Value(std::int64_t{-3}) << "-3";
    QTest::newRow("a whole fraction") << Value(2.0) << "2.0";
    QTest::newRow("a third") << Value(1.0 / 3.0) << "0.3333333333333333";
    QTest::newRow("a great number") << Value(1e300) << "1e+300";
    QTest::newRow("a text") << Value(std::string("a \"b\"\\\n\xC3\xA9")) << QString("\"a \\\"b\\\"\\\\\\n\u00e9\"");
    QTest::newRow("a symbol") << Value(Symbol{"half-open"}) << "'half-open";
    QTest::newRow("a constant") << Value(Symbol{"a.b"}) << "'a.b";
    QTest::newRow("a name with dots and hyphens") << Value(Symbol{"a.b-c"}) << "a.b-c";
}

void tst_PlanWords::valuesAreSpelledSoThatTheyReadBack() {
    QFETCH(Value, value);
    QFETCH(QString, spelling);
    QCOMPARE(QString::fromStdString(spelled(value)), spelling);
    const PlanReading reading = readPlan("((AP p ((s " + spelled(value) + "))))");
    QVERIFY(!hasErrors(reading.findings));
    QVERIFY(std::get<SenseTest>(std::get<Pattern>(reading.plan.forms.at(0)).steps.at(0)).operand->value == value);
}

void tst_PlanWords::aValueIsReadAlone_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("spelling"); // empty: it is none
    const auto row = [](const char* claim, const char* text, const char* spelling) {
        QTest::newRow(claim) << QByteArray(text) << QString(spelling);
    };
    row("a number", " 0.50 ", "0.5");
    row("nil", "nil", "nil");
    row("a truth value", "true", "true");
    row("a text", "\"a b\"", "\"a b\"");
    row("a symbol", "'red", "'red");
    row("a bare word", "red", "'red");
    row("with a comment", "7 ; days", "7");
    row("nothing", "", "");
    row("two", "1 2", "");
    row("a comparison", "1 <", "");
    row("the end of the sense", "1) (other 2", "");
    row("the end of the drive", "1))) walk) (b (trigger ((c 2", "");
    row("half a text", "\"a", "");
}

void tst_PlanWords::aValueIsReadAlone() {
    QFETCH(QByteArray, text);
    QFETCH(QString, spelling);
    const auto value = readValue(text.toStdString());
    QCOMPARE(value ? QString::fromStdString(spelled(*value)) : QString(), spelling);
}

void tst_PlanWords::theEndIsOnePastTheLastCharacter_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QPoint>("place");
    QTest::newRow("nothing") << QByteArray() << QPoint(1, 1);
    QTest::newRow("a mark only") << QByteArray("\xEF\xBB\xBF") << QPoint(1, 1);
    QTest::newRow("a line without end") << QByteArray("(a \xC3\xA9") << QPoint(1, 5);
    QTest::newRow("a line with its end") << QByteArray("(a\r\n") << QPoint(2, 1);
    QTest::newRow("blanks at the end") << QByteArray("(a\n  ") << QPoint(2, 3);
    QTest::newRow("a comment at the end") << QByteArray("(a\n; \xC3\xA9") << QPoint(2, 4);
}

void tst_PlanWords::theEndIsOnePastTheLastCharacter() {
    QFETCH(QByteArray, text);
    QFETCH(QPoint, place);
    const Spot at = tokenize({text.data(), static_cast<std::size_t>(text.size())}).tokens.back().at;
    QCOMPARE(QPoint(static_cast<int>(at.line), static_cast<int>(at.column)), place);
}

USAR_TEST(tst_PlanWords)

} // namespace tst_plan_words

#include "tst_plan_words.moc"
