#pragma once

/// The icons of the page: glyphs of the Lucide icon font, which is merged into the text faces. The build cuts the font
/// down to the characters that stand here, so a glyph is added by adding its line: the name as on lucide.dev, the code
/// point from lucide-static/font/codepoints.json.
namespace marey::app::icons {

inline constexpr char kArrowDown[] = "\ue042";
inline constexpr char kArrowLeftToLine[] = "\ue457";
inline constexpr char kArrowRightToLine[] = "\ue459";
inline constexpr char kArrowUp[] = "\ue04a";
inline constexpr char kAxis3d[] = "\ue2fe";
inline constexpr char kBone[] = "\ue358";
inline constexpr char kBox[] = "\ue061";
inline constexpr char kBrackets[] = "\ue443";
inline constexpr char kChartSpline[] = "\ue60d";
inline constexpr char kCheck[] = "\ue06c";
inline constexpr char kChevronDown[] = "\ue06d";
inline constexpr char kChevronLeft[] = "\ue06e";
inline constexpr char kChevronRight[] = "\ue06f";
inline constexpr char kChevronUp[] = "\ue070";
inline constexpr char kCircleAlert[] = "\ue077";
inline constexpr char kCircleCheck[] = "\ue226";
inline constexpr char kCircleQuestionMark[] = "\ue082";
inline constexpr char kClipboard[] = "\ue085";
inline constexpr char kClock[] = "\ue087";
inline constexpr char kContrast[] = "\ue09d";
inline constexpr char kCopy[] = "\ue09e";
inline constexpr char kCornerDownLeft[] = "\ue0a1";
inline constexpr char kDownload[] = "\ue0b2";
inline constexpr char kEllipsis[] = "\ue0b6";
inline constexpr char kExternalLink[] = "\ue0b9";
inline constexpr char kEye[] = "\ue0ba";
inline constexpr char kEyeOff[] = "\ue0bb";
inline constexpr char kFastForward[] = "\ue0bd";
inline constexpr char kFile[] = "\ue0c0";
inline constexpr char kFocus[] = "\ue29e";
inline constexpr char kFolderOpen[] = "\ue247";
inline constexpr char kFootprints[] = "\ue3b9";
inline constexpr char kGauge[] = "\ue1bf";
inline constexpr char kGhost[] = "\ue20e";
inline constexpr char kGitBranch[] = "\ue0e2";
inline constexpr char kGrid3x3[] = "\ue0e9";
inline constexpr char kHand[] = "\ue1d7";
inline constexpr char kInfo[] = "\ue0f9";
inline constexpr char kKeyboard[] = "\ue284";
inline constexpr char kLayers[] = "\ue529";
inline constexpr char kListTree[] = "\ue408";
inline constexpr char kLocateFixed[] = "\ue1db";
inline constexpr char kMaximize[] = "\ue112";
inline constexpr char kMenu[] = "\ue115";
inline constexpr char kMinus[] = "\ue11c";
inline constexpr char kMoon[] = "\ue11e";
inline constexpr char kMove3d[] = "\ue2e5";
inline constexpr char kMoveVertical[] = "\ue1c7";
inline constexpr char kOrbit[] = "\ue3e7";
inline constexpr char kPanelBottom[] = "\ue42c";
inline constexpr char kPanelLeft[] = "\ue12a";
inline constexpr char kPanelRight[] = "\ue431";
inline constexpr char kPause[] = "\ue12e";
inline constexpr char kPencil[] = "\ue1f9";
inline constexpr char kPersonStanding[] = "\ue21e";
inline constexpr char kPlay[] = "\ue13c";
inline constexpr char kPlus[] = "\ue13d";
inline constexpr char kPresentation[] = "\ue4ae";
inline constexpr char kRadius[] = "\ue52d";
inline constexpr char kRedo2[] = "\ue2a0";
inline constexpr char kRepeat[] = "\ue146";
inline constexpr char kRewind[] = "\ue147";
inline constexpr char kRotate3d[] = "\ue2ea";
inline constexpr char kRotateCcw[] = "\ue148";
inline constexpr char kRoute[] = "\ue53e";
inline constexpr char kRuler[] = "\ue14b";
inline constexpr char kScale[] = "\ue212";
inline constexpr char kScan[] = "\ue257";
inline constexpr char kSearch[] = "\ue151";
inline constexpr char kSettings2[] = "\ue245";
inline constexpr char kShapes[] = "\ue4b3";
inline constexpr char kSkipBack[] = "\ue15f";
inline constexpr char kSkipForward[] = "\ue160";
inline constexpr char kSlidersHorizontal[] = "\ue29a";
inline constexpr char kSpline[] = "\ue38b";
inline constexpr char kSquareDashedMousePointer[] = "\ue509";
inline constexpr char kStepBack[] = "\ue3e9";
inline constexpr char kStepForward[] = "\ue3ea";
inline constexpr char kSun[] = "\ue178";
inline constexpr char kTag[] = "\ue17f";
inline constexpr char kTriangleAlert[] = "\ue193";
inline constexpr char kUndo2[] = "\ue2a1";
inline constexpr char kUnfoldHorizontal[] = "\ue43d";
inline constexpr char kUnfoldVertical[] = "\ue43e";
inline constexpr char kVideo[] = "\ue1a5";
inline constexpr char kWaves[] = "\ue283";
inline constexpr char kX[] = "\ue1b2";
inline constexpr char kZoomIn[] = "\ue1b6";
inline constexpr char kZoomOut[] = "\ue1b7";

}  // namespace marey::app::icons
