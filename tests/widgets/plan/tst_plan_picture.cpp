#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/plan/plan_picture.h"
#include "widgets/style/theme.h"

namespace tst_plan_picture {

using namespace usar;
using namespace usar::widgets;

class tst_PlanPicture : public QObject {
    Q_OBJECT
private slots:
    void init();
    void everyKindIsWritten_data();
    void everyKindIsWritten();
    void svgIsWellFormedAndHoldsTheNames();
    void svgEscapesWhatXmlWouldRead();
    void pictureShowsOnlyWhatIsUnfolded();
    void hugeDrawingsAreMadeSmaller();
    void whatCannotBeWrittenIsSaidWithTheMend_data();
    void whatCannotBeWrittenIsSaidWithTheMend();

private:
    QByteArray written(const QString& name);
    QTemporaryDir folder_;
    std::unique_ptr<PlanView> view_;
};

void tst_PlanPicture::init() {
    applyTheme(Theme::Dark);
    view_ = std::make_unique<PlanView>();
    view_->resize(900, 600);
    view_->setPlan(planOf(courier_plan));
}

QByteArray tst_PlanPicture::written(const QString& name) {
    const QString file = folder_.filePath(name);
    if (const auto done = savePlanPicture(*view_, file); !done)
        return QByteArray::fromStdString(done.error().text());
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

void tst_PlanPicture::everyKindIsWritten_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("SVG") << QStringLiteral("plan.svg") << QByteArray("<?xml");
    QTest::newRow("PDF") << QStringLiteral("plan.pdf") << QByteArray("%PDF");
    QTest::newRow("PNG") << QStringLiteral("plan.png") << QByteArray("\x89PNG");
    QTest::newRow("ending in capitals") << QStringLiteral("PLAN.PNG") << QByteArray("\x89PNG");
}

void tst_PlanPicture::everyKindIsWritten() {
    QFETCH(QString, name);
    QFETCH(QByteArray, start);
    const QByteArray bytes = written(name);
    QVERIFY(bytes.startsWith(start));
    QVERIFY(bytes.size() > 1000);
}

void tst_PlanPicture::svgIsWellFormedAndHoldsTheNames() {
    QXmlStreamReader xml(written(QStringLiteral("names.svg")));
    QStringList texts;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"text")
            texts << xml.readElementText();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    for (const PlanNodeId node : view_->tree().nodes())
        QVERIFY2(texts.contains(view_->tree()[node].name), qPrintable(view_->tree()[node].name));
}

void tst_PlanPicture::svgEscapesWhatXmlWouldRead() {
    view_->setPlan(planOf("((DC life (drives ((d (trigger ((Distance 3 <))) Say(\"<a&b>\"))))))"));
    QXmlStreamReader xml(written(QStringLiteral("escaped.svg")));
    while (!xml.atEnd())
        xml.readNext();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
}

void tst_PlanPicture::pictureShowsOnlyWhatIsUnfolded() {
    const QImage whole = QImage::fromData(written(QStringLiteral("whole.png")));
    QCOMPARE(whole.size(), (view_->drawingSize() * 2.0).toSize());
    view_->foldAll();
    const QImage folded = QImage::fromData(written(QStringLiteral("folded.png")));
    QVERIFY(folded.width() < whole.width() && folded.height() < whole.height());
    QCOMPARE(folded.pixelColor(2, 2), tokens(Theme::Light).background);
}

void tst_PlanPicture::hugeDrawingsAreMadeSmaller() {
    std::string text = "((DC large (drives ";
    for (int i = 0; i < 4000; ++i)
        text += "((drive-" + std::to_string(i) + " (trigger ((A) (B) (C))) Act))";
    view_->setPlan(planOf(text + ")))"));
    QVERIFY(view_->drawingSize().height() > 100'000.0);
    const QImage image = QImage::fromData(written(QStringLiteral("huge.png")));
    QVERIFY(!image.isNull() && image.height() <= 30'000);
    QVERIFY(written(QStringLiteral("huge.pdf")).startsWith("%PDF"));
}

void tst_PlanPicture::whatCannotBeWrittenIsSaidWithTheMend_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("with_plan");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("unknown ending") << QStringLiteral("plan.gif") << true << QByteArray("End it in");
    QTest::newRow("no ending") << QStringLiteral("plan") << true << QByteArray("End it in");
    QTest::newRow("no such folder") << QStringLiteral("none/plan.svg") << true << QByteArray("Choose another folder");
    QTest::newRow("no plan") << QStringLiteral("plan.svg") << false << QByteArray("no plan");
}

void tst_PlanPicture::whatCannotBeWrittenIsSaidWithTheMend() {
    QFETCH(QString, name);
    QFETCH(bool, with_plan);
    QFETCH(QByteArray, words);
    if (!with_plan)
        view_->clear();
    const QByteArray said = written(name);
    QVERIFY2(said.contains(words) && said.contains(name.toUtf8()), said.constData());
}

USAR_TEST(tst_PlanPicture)

} // namespace tst_plan_picture

#include "tst_plan_picture.moc"
