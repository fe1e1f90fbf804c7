// Below the height map in the layers panel: whose heights it shows, and how they become colors.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QJsonObject>
#include <QWidget>

#include "core/mapping/height_fusion.h"
#include "widgets/map/height_layer.h"
#include "widgets/panels/quantity_box.h"

namespace usar::widgets {

/// All robots or the selected one; gray or color, and a range that follows the scan, with or without its extreme cells,
/// or is fixed, in meters. Starts with all robots, as a new height layer looks. GUI thread.
class HeightControls : public QWidget {
    Q_OBJECT
public:
    explicit HeightControls(QWidget* parent = nullptr);

    mapping::HeightScope scope() const;
    /// Emits scopeChanged if it changes.
    void setScope(mapping::HeightScope scope);
    HeightLook look() const;
    /// Emits nothing.
    void setLook(const HeightLook& look);
    /// The range that the map shows now; fixing the range begins with it.
    void setShownRange(const mapping::HeightRange& range);

    /// Scope and look for the settings.
    QJsonObject saveState() const;
    /// Emits scopeChanged and lookChanged if they change; what `state` does not name stays.
    void restoreState(const QJsonObject& state);

signals:
    void scopeChanged(usar::mapping::HeightScope scope);
    void lookChanged(const usar::widgets::HeightLook& look);

private:
    /// Shows the figures of a fixed range only, and tells the look.
    void tell();

    QComboBox* scope_ = nullptr;
    QCheckBox* gray_ = nullptr;
    QCheckBox* fixed_ = nullptr;
    QCheckBox* trimmed_ = nullptr; ///< never checked together with `fixed_`
    QuantityBox* lowest_ = nullptr;
    QuantityBox* highest_ = nullptr;
};

} // namespace usar::widgets
