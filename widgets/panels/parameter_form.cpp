#include "widgets/panels/parameter_form.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QPainter>
#include <QSignalBlocker>
#include <QWheelEvent>

#include "widgets/models/parameter_display.h"
#include "widgets/panels/quantity_box.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {
namespace {

constexpr int editor_width_px = 112;

/// A bar in the accent color at the row's left edge.
class Mark : public QWidget {
public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(rect(), tokens().accent); }
};

/// A combo box whose wheel scrolls the form, not its choices, until it has the focus.
class QuietComboBox : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

} // namespace

ParameterRow::ParameterRow(agent::ParameterSpec spec, QWidget* parent)
    : QWidget(parent)
    , spec_(std::move(spec))
    , value_(spec_.default_value) {
    mark_ = new Mark(this);
    mark_->setFixedWidth(3);
    label_ = new QLabel(QString::fromStdString(spec_.label), this);
    label_->setTextFormat(Qt::PlainText);
    label_->setWordWrap(true);
    editor_ = makeEditor();
    editor_->setObjectName(QString::fromStdString(spec_.id));
    editor_->setFixedWidth(editor_width_px);
    editor_->setMinimumHeight(minimum_target);
    editor_->setAccessibleName(QString::fromStdString(spec_.label));
    editor_->setAccessibleDescription(QString::fromStdString(spec_.help));
    label_->setBuddy(editor_);
    reset_ = new QToolButton(this);
    reset_->setObjectName(QStringLiteral("reset"));
    reset_->setAutoRaise(true);
    reset_->setIcon(icon(QStringLiteral("reset")));
    reset_->setFixedSize(minimum_target, minimum_target);
    const QString to_default = tr("Reset to the default, %1").arg(valueText(spec_, spec_.default_value));
    named(reset_, to_default, to_default);
    connect(reset_, &QToolButton::clicked, this, [this] {
        take(spec_.default_value);
        showValue();
    });
    for (QWidget* shy : {mark_, static_cast<QWidget*>(reset_)}) {
        QSizePolicy policy = shy->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        shy->setSizePolicy(policy);
    }
    for (QWidget* const part : {static_cast<QWidget*>(this), editor_})
        part->setToolTip(parameterToolTip(spec_));
    laidOut(new QHBoxLayout(this), {}, gap::tiny, {mark_, label_, editor_, reset_})->setStretchFactor(label_, 1);
    showValue();
}

QWidget* ParameterRow::makeEditor() {
    if (std::holds_alternative<bool>(spec_.default_value)) {
        auto* box = new QCheckBox(tr("on"), this);
        connect(box, &QCheckBox::toggled, this, [this](bool on) { take(on); });
        show_in_editor_ = [this, box] { box->setChecked(std::get<bool>(value_)); };
        return box;
    }
    if (!std::holds_alternative<std::string>(spec_.default_value))
        return makeNumber();
    if (!spec_.choices.empty())
        return makeChoice();
    auto* edit = new QLineEdit(this);
    connect(edit, &QLineEdit::editingFinished, this, [this, edit] { take(edit->text().toStdString()); });
    show_in_editor_ = [this, edit] { edit->setText(QString::fromStdString(std::get<std::string>(value_))); };
    return edit;
}

QWidget* ParameterRow::makeNumber() {
    auto* box = new QuantityBox(this);
    const DisplayUnit unit = displayUnit(spec_.unit);
    box->setDecimals(decimalsFor(spec_));
    box->setRange(spec_.minimum * unit.factor, spec_.maximum * unit.factor);
    box->setSingleStep(stepFor(spec_));
    box->setSpecialValueText(QString::fromStdString(spec_.minimum_words));
    if (!unit.text.isEmpty())
        box->setSuffix(QChar(0x00a0) + unit.text);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, unit](double shown) {
        if (std::holds_alternative<long long>(spec_.default_value))
            take(static_cast<long long>(std::llround(shown)));
        else
            take(std::clamp(shown / unit.factor, spec_.minimum, spec_.maximum));
    });
    show_in_editor_ = [this, box, unit] {
        const auto* integer = std::get_if<long long>(&value_);
        box->setValue((integer ? static_cast<double>(*integer) : std::get<double>(value_)) * unit.factor);
    };
    return box;
}

QWidget* ParameterRow::makeChoice() {
    auto* box = new QuietComboBox(this);
    for (const std::string& choice : spec_.choices)
        box->addItem(QString::fromStdString(choice));
    connect(box, &QComboBox::currentTextChanged, this, [this](const QString& text) { take(text.toStdString()); });
    show_in_editor_ = [this, box] { box->setCurrentText(QString::fromStdString(std::get<std::string>(value_))); };
    return box;
}

void ParameterRow::setValue(const agent::ParameterValue& value) {
    value_ = fitted(spec_, value);
    showValue();
}

bool ParameterRow::modified() const {
    return !sameValue(value_, spec_.default_value);
}

bool ParameterRow::matches(const QString& words) const {
    const std::string* const texts[] = {&spec_.label, &spec_.id, &spec_.group, &spec_.help};
    return std::ranges::any_of(texts, [&](const std::string* text) {
        return QString::fromStdString(*text).contains(words, Qt::CaseInsensitive);
    });
}

void ParameterRow::take(const agent::ParameterValue& value) {
    if (sameValue(value, value_))
        return;
    value_ = value;
    showMark();
    emit edited();
}

void ParameterRow::showValue() {
    const QSignalBlocker quiet(editor_);
    show_in_editor_();
    showMark();
}

void ParameterRow::showMark() {
    mark_->setVisible(modified());
    reset_->setVisible(modified());
    label_->setFont(themeFont(FontRole::Body, modified() ? QFont::DemiBold : QFont::Normal));
}

ParameterForm::ParameterForm(QWidget* parent)
    : QWidget(parent)
    , search_(
          makeSearchLine(tr("Search parameters"), tr("Shows only parameters whose name or help contains this"), this)) {
    laidOut(new QVBoxLayout(this), {}, gap::small, {makePresetRow(), makeTools(), nothing_, scroll_})
        ->setStretchFactor(scroll_, 1);
    nothing_->setWordWrap(true);
    nothing_->hide();
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    empty_state_ =
        new EmptyState(this, tr("No parameters yet"), tr("Choose a robot and a behavior; its settings appear here."));
    search_->hide();
    modified_only_->hide();
    applyFilter();
}

QWidget* ParameterForm::makePresetRow() {
    preset_row_ = new QWidget(this);
    auto* label = new QLabel(tr("Preset"), preset_row_);
    presets_box_ = new QuietComboBox(preset_row_);
    presets_box_->setObjectName(QStringLiteral("preset"));
    presets_box_->setMinimumHeight(minimum_target);
    presets_box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    named(presets_box_, tr("Preset"), tr("Sets all parameters to values that belong together"));
    label->setBuddy(presets_box_);
    laidOut(new QHBoxLayout(preset_row_), {}, gap::small, {label, presets_box_})->setStretchFactor(presets_box_, 1);
    connect(presets_box_, &QComboBox::activated, this, &ParameterForm::choosePreset);
    preset_row_->hide();
    return preset_row_;
}

void ParameterForm::setPresets(const std::vector<agent::ParameterPreset>& presets) {
    if (std::exchange(presets_, presets) != presets) {
        presets_box_->clear();
        presets_box_->addItem(tr("Defaults"));
        for (const agent::ParameterPreset& preset : presets_) {
            presets_box_->addItem(QString::fromStdString(preset.name));
            presets_box_->setItemData(presets_box_->count() - 1, QString::fromStdString(preset.help), Qt::ToolTipRole);
        }
        presets_box_->addItem(tr("Own values"));
        // It is shown, but nobody can choose it.
        presets_box_->setItemData(presets_box_->count() - 1, QVariant(0), Qt::UserRole - 1);
    }
    preset_row_->setVisible(!presets_.empty());
    showPreset();
}

void ParameterForm::choosePreset(int index) {
    const auto preset = static_cast<std::size_t>(index) - 1; // Before them are the defaults.
    if (index == 0)
        replaceValues({});
    else if (preset < presets_.size())
        replaceValues(presets_[preset].values);
}

void ParameterForm::showPreset() {
    if (presets_.empty())
        return;
    const Values shown = values();
    const auto fits = [&](const agent::ParameterPreset& preset) {
        const auto all = agent::ParameterSet::make(specs_, preset.values);
        return all && std::ranges::equal(all->values(), shown, [](const auto& a, const auto& b) {
                   return a.first == b.first && sameValue(a.second, b.second); // An angle loses digits in degrees.
               });
    };
    const auto found = std::ranges::find_if(presets_, fits);
    const auto place = static_cast<int>(found - presets_.begin());
    presets_box_->setCurrentIndex(found == presets_.end() && modified().empty() ? 0 : 1 + place);
    const QString help = found != presets_.end() ? QString::fromStdString(found->help) + '\n' : QString();
    presets_box_->setToolTip(help + tr("Sets all parameters to values that belong together"));
    presets_box_->setAccessibleDescription(presets_box_->toolTip());
}

void ParameterForm::replaceValues(const Values& values) {
    for (ParameterRow* row : rows_) {
        const auto found = values.find(row->spec().id);
        row->setValue(found == values.end() ? row->spec().default_value : found->second);
    }
    applyFilter();
    emit changed(this->values());
}

QWidget* ParameterForm::makeTools() {
    auto* tools = new QWidget(this);
    modified_only_ = makeToolButton(tr("Show only parameters that differ from their defaults"), tools);
    modified_only_->setText(tr("Modified"));
    modified_only_->setCheckable(true);
    reset_all_ = makeToolButton(tr("Reset all parameters to their defaults"), tools, "reset");
    laidOut(new QHBoxLayout(tools), {}, gap::tiny, {search_, modified_only_, reset_all_})->setStretchFactor(search_, 1);
    connect(search_, &QLineEdit::textChanged, this, &ParameterForm::applyFilter);
    connect(modified_only_, &QToolButton::toggled, this, &ParameterForm::applyFilter);
    connect(reset_all_, &QToolButton::clicked, this, &ParameterForm::resetAll);
    return tools;
}

void ParameterForm::setSpecs(const std::vector<agent::ParameterSpec>& specs) {
    if (specs == specs_)
        return;
    if (!specs_.empty())
        keptValues() = modified();
    specs_ = specs;
    buildRows();
    empty_state_->setVisible(specs_.empty());
    empty_state_->raise();
    search_->setVisible(!specs_.empty());
    modified_only_->setVisible(!specs_.empty());
    setValues(keptValues());
}

ParameterForm::Values& ParameterForm::keptValues() {
    const auto known = std::ranges::find(kept_, specs_, &decltype(kept_)::value_type::first);
    return known != kept_.end() ? known->second : kept_.emplace_back(specs_, Values{}).second;
}

void ParameterForm::buildRows() {
    groups_.clear();
    rows_.clear();
    auto* page = new QWidget;
    for (const agent::ParameterSpec& spec : specs_) {
        auto* row = new ParameterRow(spec, page);
        connect(row, &ParameterRow::edited, this, &ParameterForm::rowEdited);
        groupOf(spec.group).rows.push_back(row);
        rows_.push_back(row);
    }
    auto* column = laidOut(new QVBoxLayout(page), {0, 0, gap::small, gap::small}, gap::tiny);
    for (auto& [name, group] : groups_) {
        group.header = mutedLabel(QString::fromStdString(name), page);
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

void ParameterForm::setValues(const Values& values) {
    for (ParameterRow* row : rows_)
        if (const auto found = values.find(row->spec().id); found != values.end())
            row->setValue(found->second);
    applyFilter();
}

ParameterForm::Values ParameterForm::values() const {
    Values all;
    for (const ParameterRow* row : rows_)
        all[row->spec().id] = row->value();
    return all;
}

ParameterForm::Values ParameterForm::modified() const {
    Values changes;
    for (const ParameterRow* row : rows_)
        if (row->modified())
            changes[row->spec().id] = row->value();
    return changes;
}

void ParameterForm::resetAll() {
    if (modified().empty())
        return;
    replaceValues({});
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
    showPreset();
}

// A row that an edit makes unmodified stays visible until the filter changes, so that it does not vanish while being
// edited.
void ParameterForm::rowEdited() {
    reset_all_->setVisible(!modified().empty());
    showPreset();
    emit changed(values());
}

} // namespace usar::widgets
