"""Tests of Compose; the folders mirror the tree."""
