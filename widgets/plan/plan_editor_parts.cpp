// Construction of the plan editor's widgets.
#include <QPushButton>
#include <QResizeEvent>
#include <QShortcut>
#include <QVBoxLayout>

#include "widgets/plan/plan_editor.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int narrow_editor_px = 820;

} // namespace

QToolButton* PlanEditor::addButton(QBoxLayout* row, QAction* action) {
    QToolButton* const button = makeToolButton(action->toolTip(), this);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setAccessibleName(action->text());
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    row->addWidget(button);
    return button;
}

QToolButton* PlanEditor::addMenuButton(QBoxLayout* row, const QString& help, const QString& icon_name, QMenu* menu) {
    QToolButton* const button = makeToolButton(help, this, icon_name);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    row->addWidget(button);
    return button;
}

/// Makes the row of buttons: file, history and comparison at the left, visibility of the panes and "apply" at the
/// right.
QWidget* PlanEditor::makeHead() {
    auto* pane = new QWidget(this);
    head_ = new QBoxLayout(QBoxLayout::LeftToRight, pane);
    head_->setContentsMargins(0, 0, 0, 0);
    head_->setSpacing(gap::tiny);
    auto* files = new QHBoxLayout;
    files->setSpacing(gap::tiny);
    addMenuButton(files, tr("New plan"), QStringLiteral("page"), new_menu_);
    addButton(files, action("open"));
    addButton(files, action("save"));
    addMenuButton(files, tr("Save as, other dialects, pictures"), QStringLiteral("export"), export_menu_);
    addButton(files, action("undo"));
    addButton(files, action("redo"));
    addMenuButton(files, tr("Compare"), QStringLiteral("compare"), compare_menu_);
    title_ = new QLabel(pane);
    title_->setProperty("role", "title");
    title_->setMinimumWidth(40);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    files->addWidget(title_, 1);
    head_->addLayout(files, 1);
    auto* shown = new QHBoxLayout;
    shown->setSpacing(gap::tiny);
    const auto toggle = [&](const QString& help, const char* icon_name, QWidget* what, bool on) {
        QToolButton* const button = makeToolButton(help, this, QString::fromLatin1(icon_name));
        button->setCheckable(true);
        connect(button, &QToolButton::toggled, what, &QWidget::setVisible);
        button->setChecked(on);
        what->setVisible(on);
        shown->addWidget(button);
        return button;
    };
    palette_shown_ = toggle(tr("Shows the pieces that plans are made of"), "pieces", palette_, true);
    text_shown_ = toggle(tr("Shows the text"), "text", text_->parentWidget(), true);
    drawing_shown_ = toggle(tr("Shows the drawing"), "branches", canvas_->parentWidget(), true);
    lists_shown_ = toggle(tr("Shows findings, differences and usages"), "warning", lists_, true);
    shown->addStretch(1);
    apply_ = new QPushButton(action("apply")->text(), pane);
    apply_->setProperty("role", "primary");
    connect(apply_, &QPushButton::clicked, action("apply"), &QAction::trigger);
    shown->addWidget(apply_);
    head_->addLayout(shown);
    return pane;
}

QWidget* PlanEditor::makeTextPane() {
    auto* pane = new QWidget(this);
    auto* column = new QVBoxLayout(pane);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::tiny);
    text_ = new PlanCodeEdit(pane);
    text_->setMinimumSize(120, 80);
    text_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(text_, &QWidget::customContextMenuRequested, this, &PlanEditor::showTextMenu);
    column->addWidget(text_, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(gap::tiny);
    finding_ = new QLabel(pane);
    finding_->setWordWrap(true);
    finding_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    mend_ = makeToolButton(tr("What can be done about this (Alt+Return)"), pane, QStringLiteral("lamp"));
    mend_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    mend_->setText(tr("Mend"));
    connect(mend_, &QToolButton::clicked, this, &PlanEditor::showMends);
    row->addWidget(finding_, 1);
    row->addWidget(mend_, 0, Qt::AlignTop);
    column->addLayout(row);
    return pane;
}

QWidget* PlanEditor::makeDrawingPane() {
    auto* pane = new QWidget(this);
    auto* column = new QVBoxLayout(pane);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::tiny);
    stale_ = new QLabel(pane);
    stale_->setWordWrap(true);
    stale_->setProperty("role", "caution");
    stale_->hide();
    canvas_ = new PlanCanvas(pane);
    canvas_->setMinimumSize(120, 100);
    column->addWidget(stale_);
    column->addWidget(canvas_, 1);
    return pane;
}

QListWidget* PlanEditor::makeList(const QString& name, const QString& help) {
    auto* list = new QListWidget(lists_);
    list->setAccessibleName(name);
    list->setToolTip(help);
    list->setWordWrap(true);
    list->setIconSize({14, 14});
    list->setFrameShape(QFrame::NoFrame);
    const auto go = [this](const QListWidgetItem* item) {
        const QVariantList place = item->data(Qt::UserRole).toList();
        if (place.size() == 4 && place[0].toUInt() > 0)
            jumpTo({place[0].toUInt(), place[1].toUInt(), place[2].toUInt(), place[3].toUInt()});
    };
    connect(list, &QListWidget::itemClicked, this, go);
    connect(list, &QListWidget::itemActivated, this, go);
    return list;
}

namespace {

/// Shows what the list will contain while it is empty.
void explainEmpty(QListWidget* list, const QString& title, const QString& hint) {
    auto* const sheet = new EmptyState(list);
    sheet->setText(title, hint);
    const auto show = [sheet, list] { sheet->setVisible(list->count() == 0); };
    QObject::connect(list->model(), &QAbstractItemModel::rowsInserted, sheet, show);
    QObject::connect(list->model(), &QAbstractItemModel::rowsRemoved, sheet, show);
    QObject::connect(list->model(), &QAbstractItemModel::modelReset, sheet, show);
}

} // namespace

QWidget* PlanEditor::makeLists() {
    lists_ = new QTabWidget(this);
    lists_->setDocumentMode(true);
    lists_->setMinimumHeight(64);
    finding_list_ = makeList(tr("Findings"), tr("What is wrong with the plan; a click goes there"));
    difference_list_ = makeList(tr("Differences"), tr("What was changed; a click goes there"));
    usage_list_ = makeList(tr("Usages"), tr("Where it is used; a click goes there"));
    explainEmpty(finding_list_, tr("No findings"), tr("What is wrong is listed while you type, with what to write."));
    explainEmpty(difference_list_, tr("Nothing compared yet"),
                 tr("Compare, above, lists what was changed since another version."));
    explainEmpty(usage_list_, tr("No usages asked for"),
                 tr("Select a part and press Shift+F12: all places that use it are listed."));
    lists_->addTab(finding_list_, tr("Findings"));
    lists_->addTab(difference_list_, tr("Differences"));
    lists_->addTab(usage_list_, tr("Usages"));
    return lists_;
}

/// Makes the bar for questions that need no immediate answer; it stays above the plan until it is answered.
QWidget* PlanEditor::makeOffer() {
    offer_ = new QFrame(this);
    offer_->setProperty("role", "card");
    auto* row = new QHBoxLayout(offer_);
    row->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    offer_words_ = new QLabel(offer_);
    offer_words_->setWordWrap(true);
    row->addWidget(offer_words_, 1);
    offer_accept_ = makeToolButton(tr("Accept"), offer_);
    offer_accept_->setAutoRaise(false);
    connect(offer_accept_, &QToolButton::clicked, this, [this] {
        offer_->hide();
        if (const auto run = std::exchange(offer_run_, nullptr))
            run();
    });
    row->addWidget(offer_accept_);
    auto* no = makeToolButton(tr("No, go on"), offer_, QStringLiteral("clear"));
    connect(no, &QToolButton::clicked, offer_, &QWidget::hide);
    row->addWidget(no);
    offer_->hide();
    return offer_;
}

void PlanEditor::offer(const QString& words, const QString& accept, std::function<void()> run) {
    offer_words_->setText(words);
    offer_accept_->setText(accept);
    offer_accept_->setAccessibleName(accept);
    offer_run_ = std::move(run);
    offer_->show();
}

/// A narrow editor stacks what a wide one shows side by side, and starts without the palette.
void PlanEditor::arrange() {
    const int narrow = width() < narrow_editor_px ? 1 : 0;
    if (narrow == narrow_)
        return;
    const bool first = narrow_ < 0;
    narrow_ = narrow;
    head_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    body_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
    palette_shown_->setChecked(!narrow);
    body_->setSizes(narrow ? QList<int>{160, 300, 300} : QList<int>{200, 460, 620});
    if (first)
        column_->setSizes({600, 120});
}

void PlanEditor::resizeEvent(QResizeEvent* event) {
    arrange();
    QWidget::resizeEvent(event);
}

void PlanEditor::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && finding_list_)
        showFindings();
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
