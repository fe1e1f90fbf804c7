#include "widgets/panels/layout_dialog.h"

#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {
constexpr int layout_name_role = Qt::UserRole; ///< the name before an edit
constexpr int longest_name = 60;
} // namespace

LayoutDialog::LayoutDialog(QWidget* parent) : QDialog(parent), trouble_(new QLabel(this)) {
    setWindowTitle(tr("Layouts"));
    setAccessibleName(windowTitle());
    named(list_, tr("Own layouts"), tr("Double-click or Return shows a layout; F2 renames it"));
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    named(name_, tr("Name of the layout"), tr("The present layout is saved under this name"));
    name_->setPlaceholderText(tr("Name of the present layout"));
    name_->setMaxLength(longest_name);
    save_->setToolTip(tr("Saves where all docks are now"));
    save_->setProperty("role", "primary");
    save_->setDefault(false);
    save_->setAutoDefault(false);
    for (QWidget* control : std::initializer_list<QWidget*>{name_, save_})
        control->setMinimumHeight(minimum_target);
    trouble_->setWordWrap(true);
    trouble_->setProperty("role", "error");
    trouble_->hide();
    auto* const foot = laidOut(new QHBoxLayout, gap::small, {name_, save_});
    foot->setStretchFactor(name_, 1);
    auto* const column =
        laidOut(new QVBoxLayout(this), {gap::medium, gap::medium, gap::medium, gap::medium}, gap::small);
    column->addLayout(foot);
    column->addWidget(list_, 1);
    column->addWidget(makeRow());
    column->addWidget(trouble_);
    resize(380, 320);
    nothing_ = new EmptyState(list_->viewport(), tr("No layouts of your own yet"),
                              tr("Type a name above to keep where all docks are now."));
    connect(list_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit showRequested(item->data(layout_name_role).toString()); });
    connect(list_, &QListWidget::itemChanged, this, &LayoutDialog::takeName);
    connect(list_, &QListWidget::currentRowChanged, this, &LayoutDialog::refresh);
    connect(name_, &QLineEdit::textChanged, this, &LayoutDialog::refresh);
    const auto save = [this] {
        if (save_->isEnabled())
            emit saveRequested(name_->text().trimmed());
    };
    connect(name_, &QLineEdit::returnPressed, this, save);
    connect(save_, &QPushButton::clicked, this, save);
    refresh();
}

QWidget* LayoutDialog::makeRow() {
    auto* const row = new QWidget(this);
    auto* const line = laidOut(new QHBoxLayout(row), {}, gap::tiny);
    const auto add = [&](const QString& text, const QString& help, const QString& icon_name, bool needs_one) {
        auto* const button = named(new QToolButton(row), text, help);
        button->setText(text);
        button->setIcon(icon(icon_name));
        button->setToolButtonStyle(icon_name.isEmpty() ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon);
        button->setMinimumHeight(minimum_target);
        line->addWidget(button);
        if (needs_one)
            buttons_ << button;
        return button;
    };
    connect(add(tr("Show"), tr("Arranges the docks like this"), "play", true), &QToolButton::clicked, this,
            [this] { emit showRequested(chosen()); });
    connect(add(tr("Rename"), tr("Edits the name in the list (F2)"), "edit", true), &QToolButton::clicked, this,
            &LayoutDialog::editName);
    connect(add(tr("Delete"), tr("Deletes the layout; Undo brings it back"), "trash", true), &QToolButton::clicked,
            this, [this] { emit removeRequested(chosen()); });
    line->addStretch(1);
    connect(add(tr("Import…"), tr("Adds a layout from a file"), {}, false), &QToolButton::clicked, this,
            &LayoutDialog::importRequested);
    connect(add(tr("Export…"), tr("Writes the layout to a file for another machine"), {}, true), &QToolButton::clicked,
            this, [this] { emit exportRequested(chosen()); });
    return row;
}

void LayoutDialog::setNames(const QStringList& names) {
    const QSignalBlocker quiet(list_);
    const QString before = chosen();
    list_->clear();
    for (const QString& name : names) {
        auto* const item = new QListWidgetItem(name, list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setData(layout_name_role, name);
        if (name == before)
            list_->setCurrentItem(item);
    }
    refresh();
}

void LayoutDialog::askForName() {
    QString proposal = tr("My layout");
    for (int number = 2; names().contains(proposal); ++number)
        proposal = tr("My layout %1").arg(number);
    name_->setText(proposal);
    name_->selectAll();
    name_->setFocus();
}

void LayoutDialog::complain(const QString& text) {
    trouble_->setText(text);
    trouble_->setVisible(!text.isEmpty());
}

QString LayoutDialog::chosen() const {
    const QListWidgetItem* const item = list_->currentItem();
    return item ? item->data(layout_name_role).toString() : QString();
}

void LayoutDialog::editName() {
    if (QListWidgetItem* const item = list_->currentItem())
        list_->editItem(item);
}

void LayoutDialog::takeName(QListWidgetItem* item) {
    const QString before = item->data(layout_name_role).toString();
    const QString after = item->text().trimmed().left(longest_name);
    const QSignalBlocker quiet(list_);
    item->setText(before); // Until the owner has renamed it.
    if (after == before || after.isEmpty())
        return;
    if (names().contains(after))
        return complain(tr("There is a layout named %1 already. Choose another name.").arg(after));
    complain({});
    emit renameRequested(before, after);
}

void LayoutDialog::refresh() {
    for (QToolButton* const button : buttons_)
        button->setEnabled(!chosen().isEmpty());
    const QString name = name_->text().trimmed();
    save_->setEnabled(!name.isEmpty());
    save_->setText(names().contains(name) ? tr("Replace") : tr("Save"));
    nothing_->setVisible(list_->count() == 0);
}

QStringList LayoutDialog::names() const {
    QStringList names;
    for (int row = 0; row < list_->count(); ++row)
        names << list_->item(row)->data(layout_name_role).toString();
    return names;
}

} // namespace usar::widgets
