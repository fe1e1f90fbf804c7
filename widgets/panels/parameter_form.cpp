#include "widgets/panels/parameter_form.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parameter_row.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

ParameterForm::ParameterForm(QWidget* parent)
    : QWidget(parent)
    , search_(
          makeSearchLine(tr("Search parameters"), tr("Shows only parameters whose name or help contains this"), this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::small);
    column->addWidget(makeTools());
    column->addWidget(nothing_);
    column->addWidget(scroll_, 1);
    nothing_->setProperty("role", "muted");
    nothing_->setWordWrap(true);
    nothing_->hide();
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    empty_state_ = new EmptyState(this);
    empty_state_->setText(tr("No parameters yet"), tr("Choose a robot and a behavior; its settings appear here."));
    search_->hide();
    modified_only_->hide();
    applyFilter();
}

QWidget* ParameterForm::makeTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(gap::tiny);
    modified_only_ = makeToolButton(tr("Show only what differs from its default"), tools);
    modified_only_->setText(tr("Modified"));
    modified_only_->setCheckable(true);
    reset_all_ = makeToolButton(tr("All parameters back to their defaults"), tools, "reset");
    row->addWidget(search_, 1);
    row->addWidget(modified_only_);
    row->addWidget(reset_all_);
    connect(search_, &QLineEdit::textChanged, this, &ParameterForm::applyFilter);
    connect(modified_only_, &QToolButton::toggled, this, &ParameterForm::applyFilter);
    connect(reset_all_, &QToolButton::clicked, this, &ParameterForm::resetAll);
    return tools;
}

void ParameterForm::setSpecs(const std::vector<agent::ParameterSpec>& specs) {
    if (specs == specs_)
        return;
    keepModified();
    specs_ = specs;
    buildRows();
    empty_state_->setVisible(specs_.empty());
    empty_state_->raise();
    for (QWidget* tool : {static_cast<QWidget*>(search_), static_cast<QWidget*>(modified_only_)})
        tool->setVisible(!specs_.empty());
    const auto known = std::ranges::find(kept_, specs_, &decltype(kept_)::value_type::first);
    setValues(known == kept_.end() ? std::map<std::string, agent::ParameterValue>{} : known->second);
}

void ParameterForm::keepModified() {
    if (specs_.empty())
        return;
    const auto known = std::ranges::find(kept_, specs_, &decltype(kept_)::value_type::first);
    if (known != kept_.end())
        known->second = modified();
    else
        kept_.emplace_back(specs_, modified());
}

void ParameterForm::buildRows() {
    groups_.clear();
    auto* page = new QWidget;
    for (const agent::ParameterSpec& spec : specs_) {
        auto* row = new ParameterRow(spec, page);
        connect(row, &ParameterRow::edited, this, &ParameterForm::rowEdited);
        groupOf(spec.group).rows.push_back(row);
    }
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, gap::small, gap::small);
    column->setSpacing(gap::tiny);
    for (auto& [name, group] : groups_) {
        group.header = new QLabel(QString::fromStdString(name), page);
        group.header->setProperty("role", "muted");
        group.header->setContentsMargins(0, column->isEmpty() ? 0 : gap::small, 0, 0);
        column->addWidget(group.header);
        for (ParameterRow* row : group.rows)
            column->addWidget(row);
    }
    column->addStretch();
    // Deleted later, because code that reacts to an edit of one of its rows may set other specs.
    if (QWidget* old = scroll_->takeWidget())
        old->deleteLater();
    scroll_->setWidget(page);
}

ParameterForm::Group& ParameterForm::groupOf(const std::string& name) {
    const auto found = std::ranges::find(groups_, name, &std::pair<std::string, Group>::first);
    return found != groups_.end() ? found->second : groups_.emplace_back(name, Group{}).second;
}

void ParameterForm::setValues(const std::map<std::string, agent::ParameterValue>& values) {
    for (auto& [name, group] : groups_)
        for (ParameterRow* row : group.rows)
            if (const auto found = values.find(row->spec().id); found != values.end())
                row->setValue(found->second);
    applyFilter();
}

std::map<std::string, agent::ParameterValue> ParameterForm::values() const {
    std::map<std::string, agent::ParameterValue> all;
    for (const auto& [name, group] : groups_)
        for (const ParameterRow* row : group.rows)
            all[row->spec().id] = row->value();
    return all;
}

std::map<std::string, agent::ParameterValue> ParameterForm::modified() const {
    std::map<std::string, agent::ParameterValue> changes;
    for (const auto& [name, group] : groups_)
        for (const ParameterRow* row : group.rows)
            if (row->modified())
                changes[row->spec().id] = row->value();
    return changes;
}

void ParameterForm::setFilter(const QString& words) {
    search_->setText(words);
}

void ParameterForm::setModifiedOnly(bool on) {
    modified_only_->setChecked(on);
}

void ParameterForm::resetAll() {
    if (modified().empty())
        return;
    for (auto& [name, group] : groups_)
        for (ParameterRow* row : group.rows)
            row->setValue(row->spec().default_value);
    applyFilter();
    emit changed(values());
}

void ParameterForm::applyFilter() {
    const QString words = search_->text().trimmed();
    bool any = false;
    for (auto& [name, group] : groups_) {
        bool any_in_group = false;
        for (ParameterRow* row : group.rows) {
            const bool fits = row->matches(words) && (!modified_only_->isChecked() || row->modified());
            row->setVisible(fits);
            any_in_group = any_in_group || fits;
        }
        group.header->setVisible(any_in_group && !name.empty());
        any = any || any_in_group;
    }
    nothing_->setText(words.isEmpty() ? tr("Every parameter is at its default.")
                                      : tr("No parameter matches “%1”.").arg(words));
    nothing_->setVisible(!any && !groups_.empty());
    reset_all_->setVisible(!modified().empty());
}

// A row that an edit makes unmodified stays visible until the filter changes, so that it does not vanish while being
// edited.
void ParameterForm::rowEdited() {
    reset_all_->setVisible(!modified().empty());
    emit changed(values());
}

} // namespace usar::widgets
