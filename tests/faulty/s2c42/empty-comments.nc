(a plate)
(of steel)
