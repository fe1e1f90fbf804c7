#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/layers_panel.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"

namespace tst_scroll_box {

using namespace usar::widgets;

class tst_ScrollBox : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void tallContentAsksForLittleRoom();
    void contentHasAllTheRoomThatThereIs();
    void textThatWrapsScrollsOnlyWhereItMust();
    void contentThatGrowsIsReachedByScrolling();
};

void tst_ScrollBox::tallContentAsksForLittleRoom() {
    auto* const layers = new LayersPanel;
    const ScrollBox box(layers);
    QVERIFY(layers->minimumSizeHint().height() > 300);
    QVERIFY(box.minimumSizeHint().height() <= ScrollBox::least_px);
    QVERIFY(box.sizeHint().height() <= 260);
    QVERIFY(box.minimumSizeHint().width() >= layers->minimumSizeHint().width());
}

void tst_ScrollBox::contentHasAllTheRoomThatThereIs() {
    auto* const layers = new LayersPanel;
    ScrollBox box(layers);
    box.resize(300, 900);
    box.show();
    QCOMPARE(layers->size(), box.size());
    box.resize(300, 200);
    QVERIFY(layers->height() >= layers->minimumSizeHint().height());
    QTRY_COMPARE(layers->width(), box.viewport()->width());
    QVERIFY(box.verticalScrollBar()->isVisible());
    QVERIFY(!box.horizontalScrollBar()->isVisible());
}

void tst_ScrollBox::textThatWrapsScrollsOnlyWhereItMust() {
    auto* const content = new QWidget;
    auto* const text = new QLabel(QStringLiteral("Says at length what it does. ").repeated(8), content);
    text->setWordWrap(true);
    auto* const list = new QListView(content); // It would like 192 pixels, but needs few.
    list->setMinimumHeight(40);
    laidOut(new QVBoxLayout(content), {}, gap::small, {text, list});
    ScrollBox box(content);
    box.resize(300, text->heightForWidth(300) + gap::small + 60);
    box.show();
    QVERIFY(!box.verticalScrollBar()->isVisible());
    QCOMPARE(content->height(), box.height());
}

void tst_ScrollBox::contentThatGrowsIsReachedByScrolling() {
    auto* const content = new QWidget;
    auto* const column = laidOut(new QVBoxLayout(content), {}, gap::small);
    ScrollBox box(content);
    box.resize(200, 100);
    box.show();
    QVERIFY(!box.verticalScrollBar()->isVisible());
    for (int i = 0; i < 12; ++i)
        column->addWidget(new QPushButton(QString::number(i), content));
    QTRY_VERIFY(box.verticalScrollBar()->isVisible());
    QVERIFY(content->height() >= content->minimumSizeHint().height());
    QCOMPARE(box.height(), 100);
}

USAR_TEST(tst_ScrollBox)

} // namespace tst_scroll_box

#include "tst_scroll_box.moc"
